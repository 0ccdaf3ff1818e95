#include "renderer/svg_canvas.hpp"

#include <glib.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "renderer/opengl/pixel_canvas.hpp"
#include "renderer/opengl/space_picture.hpp"
#include "tests/renderer/coverage.hpp"
#include "tests/renderer/png_file.hpp"
#include "tests/renderer/scenes.hpp"

namespace byhand::renderer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// What an XML parser finds: the text of each <text>, all ids, the number of each element.
struct Parsed {
  std::vector<std::string> texts, ids, titles;
  std::map<std::string, int> count;
  std::string error;
};

Parsed parse(const std::string& svg) {
  Parsed parsed;
  GMarkupParser parser{};
  parser.start_element = [](GMarkupParseContext*, const char* name, const char** names, const char** values,
                            gpointer data, GError**) {
    auto& all = *static_cast<Parsed*>(data);
    ++all.count[name];
    if (std::string(name) == "text") all.texts.emplace_back();
    for (int i = 0; names[i]; ++i)
      if (std::string(names[i]) == "id") all.ids.emplace_back(values[i]);
  };
  parser.text = [](GMarkupParseContext* context, const char* text, gsize size, gpointer data, GError**) {
    auto& all = *static_cast<Parsed*>(data);
    const std::string element = g_markup_parse_context_get_element(context);
    if (element == "text" || element == "tspan") all.texts.back().append(text, size);
    if (element == "title" || element == "desc") all.titles.emplace_back(text, size);
  };
  GMarkupParseContext* context = g_markup_parse_context_new(&parser, GMarkupParseFlags(0), &parsed, nullptr);
  GError* error = nullptr;
  if (!g_markup_parse_context_parse(context, svg.data(), gssize(svg.size()), &error) ||
      !g_markup_parse_context_end_parse(context, &error)) {
    parsed.error = error->message;
    g_error_free(error);
  }
  g_markup_parse_context_free(context);
  return parsed;
}

std::string written(const scenes::Scene& scene, int width = 1280) {
  SvgCanvas canvas(width, "figure", space_picture_url);
  scene.draw(canvas);
  return canvas.svg("a scene");
}

std::filesystem::path new_folder() {
  std::filesystem::path folder = testing::TempDir() + "byhand_svg_" + std::to_string(getpid());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

class Svg : public testing::TestWithParam<scenes::Scene> {};

TEST_P(Svg, IsWellFormed) { EXPECT_EQ(parse(written(GetParam())).error, ""); }

TEST_P(Svg, IsTheSameTwice) { EXPECT_EQ(written(GetParam()), written(GetParam())); }

TEST_P(Svg, IsSmall) {
  SvgCanvas canvas(1280, "figure");  // without pixels of space
  GetParam().draw(canvas);
  EXPECT_LT(canvas.svg("a scene").size(), 50'000u);
}

// Another program's picture of the SVG against our pixels. Both smooth edges in their own way, so the pictures are
// compared by the mean of 8 × 8 pixels; a shape that is missing, misplaced or of another colour is far off.
TEST_P(Svg, LooksLikeThePixels) {
  if (std::system("command -v rsvg-convert >/dev/null") != 0) GTEST_SKIP() << "librsvg2-bin is not installed";
  const std::filesystem::path folder = new_folder(), svg = folder / "a.svg", png = folder / "a.png";
  std::ofstream(svg) << written(GetParam());
  ASSERT_EQ(std::system(("rsvg-convert '" + svg.string() + "' -o '" + png.string() + "'").c_str()), 0);
  const Image other = read_png(png);
  PixelCanvas canvas(1280, 720);
  GetParam().draw(canvas);
  const Image ours = canvas.image();
  ASSERT_EQ(other.width, ours.width);
  ASSERT_EQ(other.height, ours.height);
  constexpr int side = 8;
  double most = 0, sum = 0;
  for (int y = 0; y < ours.height; y += side)
    for (int x = 0; x < ours.width; x += side)
      for (int channel = 0; channel < 3; ++channel) {
        double difference = 0;
        for (int j = 0; j < side; ++j)
          for (int i = 0; i < side; ++i)
            difference += ours.pixel(x + i, y + j)[channel] - other.pixel(x + i, y + j)[channel];
        difference = std::abs(difference) / (side * side);
        most = std::max(most, difference), sum += difference;
      }
  EXPECT_LT(most, 48) << "of 255";
  EXPECT_LT(sum / (3.0 * ours.width * ours.height / (side * side)), 0.35) << "of 255";
  std::filesystem::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Svg, testing::ValuesIn(scenes::all),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST(SvgCanvas, NeedsNoOpenGL) {
  const std::filesystem::path folder = new_folder();
  ASSERT_EQ(std::system((std::string(WRITE_SVG) + " '" + folder.string() + "'").c_str()), 0);
  for (const scenes::Scene& scene : scenes::all) {
    std::ifstream in(folder / (std::string(scene.name) + ".svg"));
    const std::string svg(std::istreambuf_iterator<char>(in), {});
    EXPECT_THAT(parse(svg).titles, ElementsAre(scene.name, "a scene of the tests"));
  }
  std::filesystem::remove_all(folder);
}

TEST(SvgCanvas, KeepsTextAsText) {
  SvgCanvas canvas(1280, "a");
  canvas.text({100, 100}, "Ċ = JV < 3 & \"λ̇_1^2\"\nM^{−1} \\_");
  const Parsed parsed = parse(canvas.svg("title"));
  EXPECT_THAT(parsed.texts, ElementsAre("Ċ = JV < 3 & \"λ̇12\"", "M−1 _"));
  EXPECT_THAT(canvas.svg("title"), HasSubstr("DejaVu Sans"));
}

TEST(SvgCanvas, TellsAScreenReaderTitleAndDescription) {
  SvgCanvas canvas(1280, "a");
  const std::string svg = canvas.svg("C < 0", "falls \"by\" half & stays");
  EXPECT_THAT(parse(svg).titles, ElementsAre("C < 0", "falls \"by\" half & stays"));
  EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"a-title a-description\""));
  EXPECT_THAT(canvas.svg("only a title"), HasSubstr("aria-labelledby=\"a-title\""));
  EXPECT_THAT(canvas.svg(""), testing::AllOf(HasSubstr("aria-hidden=\"true\""), Not(HasSubstr("labelledby")),
                                             Not(HasSubstr("<title"))));
}

TEST(SvgCanvas, BeginsAllIdsWithItsNameAndUsesNoOthers) {
  SvgCanvas canvas(1280, "one");
  canvas.clip(Rectangle{10, 10, 100, 100});
  canvas.disc({50, 50}, 20);
  canvas.clip(Rectangle{200, 10, 100, 100});
  canvas.disc({250, 50}, 20);
  canvas.clip(Rectangle{10, 10, 100, 100});
  canvas.disc({50, 50}, 10);
  canvas.clip(std::nullopt);
  const std::string svg = canvas.svg("title", "description");
  const Parsed parsed = parse(svg);
  EXPECT_EQ(parsed.error, "");
  EXPECT_THAT(parsed.ids, testing::Each(testing::StartsWith("one-")));
  EXPECT_THAT(parsed.ids, testing::IsSupersetOf({"one-clip0", "one-clip1"}));
  EXPECT_EQ(parsed.count.at("clipPath"), 2) << "equal clips share one";
  EXPECT_EQ(parsed.count.at("g"), 3);
}

TEST(SvgCanvas, WritesWhatNeighboursShareOnce) {
  SvgCanvas canvas(1280, "a");
  for (int i = 0; i < 3; ++i) canvas.line({100, 100.0 + i}, {200, 100.0 + i}, {palette::constraint, 4});
  for (int i = 0; i < 3; ++i) canvas.disc({50, 50.0 + i}, 20);
  canvas.line({100, 200}, {200, 200}, {palette::constraint, 4});
  const std::string svg = canvas.svg("title");
  EXPECT_THAT(svg, HasSubstr("<path d=\"M100 620h100M100 619h100M100 618h100\" fill=\"none\" stroke="));
  EXPECT_THAT(svg, HasSubstr("<path d=\"M100 520h100\" fill=\"none\" stroke="));
  EXPECT_EQ(parse(svg).count.at("g"), 1);
}

TEST(SvgCanvas, JoinsCellsOfOneColour) {
  SvgCanvas canvas(1280, "a");
  const auto cell = [&](double x, double y, Colour colour) {
    canvas.rectangle({x, y, 10, 10}, {colour, {{}, 0}});
  };
  cell(100, 620, palette::constraint);
  cell(110, 620, palette::constraint);
  cell(130, 620, palette::constraint);
  cell(140, 610, palette::constraint);
  cell(150, 610, palette::force);
  cell(160, 610, palette::constraint);
  EXPECT_THAT(canvas.svg("title"),
              testing::AllOf(HasSubstr(" d=\"M100 90h20v10h-20zM130 90h10v10h-10zM140 100h10v10h-10z"
                                       "M160 100h10v10h-10z\"/><path fill"),
                             HasSubstr(" d=\"M150 100h10v10h-10z\"/></g></svg>")));
}

TEST(SvgCanvas, ACellAboveAnotherIsDrawnAfterIt) {
  SvgCanvas canvas(1280, "a");
  canvas.rectangle({100, 100, 40, 40}, {palette::constraint, {{}, 0}});
  canvas.rectangle({110, 110, 20, 20}, {palette::force, {{}, 0}});
  canvas.rectangle({115, 115, 5, 5}, {palette::constraint, {{}, 0}});
  const std::string svg = canvas.svg("title");
  const auto large = svg.find("h40v40"), middle = svg.find("h20v20"), small = svg.find("h5v5");
  EXPECT_LT(large, middle);
  EXPECT_LT(middle, small);
  EXPECT_NE(small, std::string::npos);
}

TEST(SvgCanvas, RoundsAHalfAlikeWhereItMissesALittle) {
  const auto written = [](double y) {
    SvgCanvas canvas(1280, "a");
    canvas.line({100, y}, {200, y});
    return canvas.svg("title");
  };
  for (const double half : {350.125, 350.375, 350.625}) {
    EXPECT_EQ(written(std::nextafter(half, 0)), written(half));
    EXPECT_EQ(written(std::nextafter(half, 1000)), written(half));
  }
  EXPECT_NE(written(350.125), written(350.135));
}

TEST(SvgCanvas, EndsAGroupWhereAClipBegins) {
  SvgCanvas canvas(1280, "a");
  const auto two_discs = [&] {
    for (int i = 0; i < 2; ++i) canvas.disc({50, 50.0 + i}, 20);
  };
  two_discs();
  canvas.clip(Rectangle{10, 10, 100, 100});
  two_discs();
  canvas.clip(std::nullopt);
  const std::string svg = canvas.svg("title");
  EXPECT_EQ(parse(svg).error, "");
  EXPECT_THAT(svg, HasSubstr("</g><g clip-path=\"url(#a-clip0)\"><g "));
  EXPECT_THAT(svg, HasSubstr("</g></g>"));
}

TEST(SvgCanvas, IsEmptyAfterClear) {
  SvgCanvas canvas(1280, "a");
  const std::string empty = canvas.svg("title");
  canvas.clip(Rectangle{10, 10, 100, 100});
  scenes::space(canvas);
  scenes::charts(canvas);
  EXPECT_NE(canvas.svg("title"), empty);
  canvas.clear();
  EXPECT_EQ(canvas.svg("title"), empty);
  EXPECT_TRUE(canvas.windows().empty());
}

TEST(SvgCanvas, LeavesAHoleForASceneInSpaceUnlessItIsDrawn) {
  SvgCanvas canvas(1280, "a");
  Space scene(fit({0, 0, 0}, 1, {-1, 2, -0.8}, {100, 200, 300, 400}));
  scene.sphere({0, 0, 0}, 0.5, palette::body);
  canvas.draw(scene);
  ASSERT_EQ(canvas.windows().size(), 1u);
  EXPECT_EQ(canvas.windows()[0].frame, (PixelBox{100, 120, 300, 400}));
  EXPECT_THAT(canvas.svg("title"), HasSubstr("M0 0h1280v720h-1280zM100 120h300v400h-300z"));
  EXPECT_THAT(canvas.svg("title"), Not(HasSubstr("<image")));

  SvgCanvas drawn(1280, "a", space_picture_url);
  drawn.draw(scene);
  EXPECT_THAT(drawn.svg("title"), Not(HasSubstr("M100 120h300v400h-300z")));
  EXPECT_EQ(parse(drawn.svg("title")).count.at("image"), 1);
}

TEST(SvgCanvas, FadesATrailFromNothingToFullColour) {
  SvgCanvas canvas(1280, "a");
  std::vector<Point> line;
  for (int i = 0; i <= 100; ++i) line.push_back({100.0 + i, 100});
  canvas.trail(line, {palette::constraint, 4});
  const std::string svg = canvas.svg("title");
  EXPECT_THAT(svg, HasSubstr("stroke-opacity=\".02\""));
  EXPECT_THAT(svg, HasSubstr("stroke-opacity=\".98\""));
}

TEST(SvgCanvas, RefusesAPageThatIsTooNarrowOrTooWide) {
  EXPECT_THROW(SvgCanvas(10, "a"), std::invalid_argument);
  EXPECT_THROW(SvgCanvas(10000, "a"), std::invalid_argument);
}

TEST(Svg, APageThatIsHigherThanWideStacksItsPanelsAndIsCutBelowTheLast) {
  SvgCanvas phone(490, "phone"), screen(1280, "screen");
  const auto [upper, lower] = phone.page().panels(0.6, 20, 0.5);
  EXPECT_EQ(upper.width, 490);
  EXPECT_EQ(upper.height, 350);
  EXPECT_EQ(lower.top(), 350);
  EXPECT_EQ(screen.page().panels(0.6, 20, 0.5).first.width, 756);
  EXPECT_EQ(phone.page().grid(2, 3, 0)[1].width, 245);
  EXPECT_EQ(screen.page().grid(2, 3, 0)[1].height, 360);
  EXPECT_EQ(phone.page().lowered(60).height, 600);
  EXPECT_EQ(screen.page().lowered(60).height, 720);
  EXPECT_EQ(screen.page(0.8).height, 720);
  EXPECT_THAT(screen.svg(""), HasSubstr("viewBox=\"0 0 1280 720\""));
  EXPECT_EQ(phone.page(0.8).y, 328);
  EXPECT_EQ(phone.page().height, 392);
  EXPECT_THAT(phone.svg(""), HasSubstr("viewBox=\"0 0 490 392\""));
}

TEST(Svg, OnAPageThatIsHigherThanWideNoTextCrossesTheEdge) {
  SvgCanvas canvas(490, "narrow");
  canvas.list_labels();
  canvas.text({480, 300}, "to the left", {.anchor = Anchor::left});
  canvas.text({10, 718}, "lower", {.anchor = Anchor::centre});
  canvas.text({245, 300},
              "a sentence of many words, which has to be broken into several lines to be seen as a whole");
  for (const Label& label : canvas.labels()) {
    EXPECT_GE(label.box.x, 4 - 1e-9) << label.text;
    EXPECT_LE(label.box.right(), 486 + 1e-9) << label.text;
    EXPECT_LE(label.box.top(), 716 + 1e-9) << label.text;
  }
  EXPECT_THAT(canvas.labels()[2].text, HasSubstr("\n"));
}

}  // namespace
}  // namespace byhand::renderer
