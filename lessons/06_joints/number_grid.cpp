#include "lessons/06_joints/number_grid.hpp"

namespace byhand::joints {

void draw_grid(Canvas& canvas, const Eigen::MatrixXd& matrix, const Point& at, const Point& cell,
               const GridLabels& labels) {
  const double most = matrix.cwiseAbs().maxCoeff();
  for (int j = 0; j < static_cast<int>(labels.columns.size()); ++j)
    canvas.text({at.x() + (j + 0.5) * cell.x(), at.y() + 12}, labels.columns[j],
                {.size = 16, .colour = palette::muted});
  for (int i = 0; i < matrix.rows(); ++i) {
    const double y = at.y() - (i + 1) * cell.y();
    if (i < static_cast<int>(labels.rows.size()))
      canvas.text({at.x() - 8, y + cell.y() / 2}, labels.rows[i],
                  {.size = 16, .colour = palette::muted, .anchor = Anchor::right});
    for (int j = 0; j < matrix.cols(); ++j) {
      const Rectangle box{at.x() + j * cell.x(), y, cell.x(), cell.y()};
      const double value = std::abs(matrix(i, j)) < 1e-12 * most ? 0 : matrix(i, j);
      canvas.rectangle(box,
                       {value == 0 ? palette::paper : palette::diverging(0.5 * value / most), {palette::grid, 1}});
      const std::string number = course::number(value, 3);
      // As large as the cell allows, with a little air.
      const double width = canvas.measure({0, 0}, number, {.size = 13}).width;
      canvas.text(box.centre(), number,
                  {.size = 13 * std::min(1.0, (cell.x() - 6) / width),
                   .colour = value == 0 ? palette::muted : palette::ink});
    }
  }
}

}  // namespace byhand::joints
