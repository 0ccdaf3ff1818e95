#include "lessons/page/article_equations.hpp"

#include <fmt/format.h>

#include <array>

#include "lessons/page/error.hpp"

namespace byhand::course {
namespace {

// R. Gaul, "Modelling and Solving Physical Constraints", 2013, (1) to (23).
const std::array<Formula, article_equations> article = {{
    {"C(l₁, a₁, l₂, a₂) = 0", R"(C(l_1, a_1, l_2, a_2) = 0)"},
    {"C(l₁, a₁, l₂, a₂) = ½[(P₂ − P₁)² − L²] = 0",
     R"(C(l_1, a_1, l_2, a_2) = \tfrac{1}{2}\left[(P_2 - P_1)^2 - L^2\right] = 0)"},
    {"Ċ(l₁, a₁, l₂, a₂) = 0", R"(\dot{C}(l_1, a_1, l_2, a_2) = 0)"},
    {"Ċ(l₁, a₁, l₂, a₂) = JV = 0", R"(\dot{C}(l_1, a_1, l_2, a_2) = JV = 0)"},
    {"F = λJᵀ", R"(F = \lambda J^T)"},
    {"    ⎡ l₁ ⎤\n"
     "J = ⎢ a₁ ⎥\n"
     "    ⎢ l₂ ⎥\n"
     "    ⎣ a₂ ⎦",
     R"(J = \begin{bmatrix} l_1 \\ a_1 \\ l_2 \\ a_2 \end{bmatrix})"},
    {"                        ⎡ v₁ ⎤\n"
     "JV = [ l₁  a₁  l₂  a₂ ] ⎢ ω₁ ⎥\n"
     "                        ⎢ v₂ ⎥\n"
     "                        ⎣ ω₂ ⎦",
     R"(JV = \begin{bmatrix} l_1 & a_1 & l_2 & a_2 \end{bmatrix} \begin{bmatrix} v_1 \\ \omega_1 \\ v_2 \\ \omega_2 \end{bmatrix})"},
    {"JV = l₁·v₁ + a₁·ω₁ + l₂·v₂ + a₂·ω₂",
     R"(JV = l_1 \cdot v_1 + a_1 \cdot \omega_1 + l_2 \cdot v_2 + a_2 \cdot \omega_2)"},
    {"Ċ = (P₂ − P₁)(Ṗ₂ − Ṗ₁)", R"(\dot{C} = (P_2 - P_1)(\dot{P}_2 - \dot{P}_1))"},
    {"Ċ = (P₂ − P₁)((v₂ + ω₂ × r₂) − (v₁ + ω₁ × r₁))",
     R"(\dot{C} = (P_2 - P_1)((v_2 + \omega_2 \times r_2) - (v_1 + \omega_1 \times r_1)))"},
    {"(P₂ − P₁) = d", R"((P_2 - P_1) = d)"},
    {"Ċ = (d·v₂ + d·ω₂ × r₂) − (d·v₁ + d·ω₁ × r₁)",
     R"(\dot{C} = (d \cdot v_2 + d \cdot \omega_2 \times r_2) - (d \cdot v_1 + d \cdot \omega_1 \times r_1))"},
    {"Ċ = (d·v₂ + ω₂·r₂ × d) − (d·v₁ + ω₁·r₁ × d)",
     R"(\dot{C} = (d \cdot v_2 + \omega_2 \cdot r_2 \times d) - (d \cdot v_1 + \omega_1 \cdot r_1 \times d))"},
    {"J = [ −d   −r₁ × d   d   r₂ × d ]",
     R"(J = \begin{bmatrix} -d & -r_1 \times d & d & r_2 \times d \end{bmatrix})"},
    {"J = [ −n   −r₁ × n   n   r₂ × n ]",
     R"(J = \begin{bmatrix} -n & -r_1 \times n & n & r_2 \times n \end{bmatrix})"},
    {"J = [ −t   −r₁ × t   t   r₂ × t ]",
     R"(J = \begin{bmatrix} -t & -r_1 \times t & t & r_2 \times t \end{bmatrix})"},
    {"λ = −(JV + b) / (JM⁻¹Jᵀ)", R"(\lambda = \frac{-(JV + b)}{JM^{-1}J^T})"},
    {"      ⎡ m₁⁻¹  0     0     0   ⎤\n"
     "M⁻¹ = ⎢ 0     I₁⁻¹  0     0   ⎥\n"
     "      ⎢ 0     0     m₂⁻¹  0   ⎥\n"
     "      ⎣ 0     0     0     I₂⁻¹⎦",
     R"(M^{-1} = \begin{bmatrix} m_1^{-1} & 0 & 0 & 0 \\ 0 & I_1^{-1} & 0 & 0 \\ 0 & 0 & m_2^{-1} & 0 \\ 0 & 0 & 0 & I_2^{-1} \end{bmatrix})"},
    {"JM⁻¹Jᵀ = (l₁·l₁) m₁⁻¹ + (l₂·l₂) m₂⁻¹ + a₁(I₁⁻¹a₁) + a₂(I₂⁻¹a₂)",
     R"(JM^{-1}J^T = (l_1 \cdot l_1)\,m_1^{-1} + (l_2 \cdot l_2)\,m_2^{-1} + a_1 (I_1^{-1} a_1) + a_2 (I_2^{-1} a_2))"},
    {"F = λJᵀ,   V_final = V_initial + m⁻¹F\n"
     "⎡ v₁ ⎤      ⎡ m₁⁻¹  0     0     0   ⎤ ⎡ λl₁ ⎤\n"
     "⎢ ω₁ ⎥  +=  ⎢ 0     I₁⁻¹  0     0   ⎥ ⎢ λa₁ ⎥\n"
     "⎢ v₂ ⎥      ⎢ 0     0     m₂⁻¹  0   ⎥ ⎢ λl₂ ⎥\n"
     "⎣ ω₂ ⎦      ⎣ 0     0     0     I₂⁻¹⎦ ⎣ λa₂ ⎦",
     R"(F = \lambda J^T, \quad V_{final} = V_{initial} + m^{-1} F, \quad \begin{bmatrix} v_1 \\ \omega_1 \\ v_2 \\ \omega_2 \end{bmatrix} \mathrel{+}= \begin{bmatrix} m_1^{-1} & 0 & 0 & 0 \\ 0 & I_1^{-1} & 0 & 0 \\ 0 & 0 & m_2^{-1} & 0 \\ 0 & 0 & 0 & I_2^{-1} \end{bmatrix} \begin{bmatrix} \lambda l_1 \\ \lambda a_1 \\ \lambda l_2 \\ \lambda a_2 \end{bmatrix})"},
    {"Ċ = JV + b = 0", R"(\dot{C} = JV + b = 0)"},
    {"JV = −βC", R"(JV = -\beta C)"},
    {"C = [ −x₁  −r₁  x₂  r₂ ]·n", R"(C = \begin{bmatrix} -x_1 & -r_1 & x_2 & r_2 \end{bmatrix} \cdot \vec{n})"},
}};

}  // namespace

const Formula& article_equation(int number) {
  if (number < 1 || number > static_cast<int>(article.size()))
    throw LessonError(fmt::format("the article has no equation ({}), only (1) to ({})", number, article.size()));
  return article[static_cast<size_t>(number - 1)];
}

}  // namespace byhand::course
