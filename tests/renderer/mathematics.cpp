#include "renderer/mathematics.hpp"

#include <gtest/gtest.h>

#include <string>

#include "renderer/font.hpp"

namespace byhand::renderer {
namespace {

// The label with its italic parts in ⟨ ⟩.
std::string marked(std::string_view label) {
  std::string all;
  for (const Font::Piece& piece : Font::pieces(label)) all += piece.italic ? "⟨" + piece.words + "⟩" : piece.words;
  return all;
}

TEST(Mathematics, QuantitiesAreItalic) {
  EXPECT_EQ(marked("v"), "⟨v⟩");
  EXPECT_EQ(marked("λ̇_1^2"), "⟨λ̇⟩12");
  EXPECT_EQ(marked("Ċ = JV = ∇C·ẋ"), "⟨Ċ⟩ = ⟨JV⟩ = ∇⟨C⟩·⟨ẋ⟩");
  EXPECT_EQ(marked("λ·|d| = −0.42 N·s"), "⟨λ⟩·|⟨d⟩\u200a| = −0.42 N·s");
  EXPECT_EQ(marked("a_2 = r_2 × n = −0.379 m"), "⟨a⟩2 = ⟨r⟩2 × ⟨n⟩ = −0.379 m");
  EXPECT_EQ(marked("(ωh)²/2β"), "(⟨ωh⟩)²/2⟨β⟩");
  EXPECT_EQ(marked("N³ = 7.84 kw²/2mg"), "⟨N⟩³ = 7.84 ⟨kw⟩²/2⟨mg⟩");
  EXPECT_EQ(marked("x_i"), "⟨x⟩⟨i⟩");
  EXPECT_EQ(marked("C(t)"), "⟨C⟩(⟨t⟩)");
  EXPECT_EQ(marked("mR²ω = mga"), "⟨mR⟩²⟨ω⟩ = ⟨mga⟩");
  EXPECT_EQ(marked("torque (mgl)"), "torque (⟨mgl⟩)");
  EXPECT_EQ(marked("½mv²"), "½⟨mv⟩²");
  EXPECT_EQ(marked("largest error (gh)"), "largest error (⟨gh⟩)");
}

TEST(Mathematics, UnitsAreUpright) {
  EXPECT_EQ(marked("L = 2 m"), "⟨L⟩ = 2 m");
  EXPECT_EQ(marked("t (s)"), "⟨t⟩ (s)");
  EXPECT_EQ(marked("at 0\u00a0m/s and v"), "at 0\u00a0m/s and ⟨v⟩");
  EXPECT_EQ(marked("force (N s/m)"), "force (N s/m)");
  EXPECT_EQ(marked("entry of J (1, m)"), "entry of ⟨J⟩ (1, m)");
  EXPECT_EQ(marked("A (1/kg)"), "⟨A⟩ (1/kg)");
  EXPECT_EQ(marked("g = 9.81 m/s^2, h"), "⟨g⟩ = 9.81 m/s2, ⟨h⟩");
  EXPECT_EQ(marked("slid in 1 s (m)"), "slid in 1 s (m)");
  EXPECT_EQ(marked("m/√kg"), "m/√kg");
  EXPECT_EQ(marked("= (2.9) + (−1.1) m²/s"), "= (2.9) + (−1.1) m²/s");
  EXPECT_EQ(marked("λ/h (N)"), "⟨λ⟩/⟨h⟩ (N)");
  EXPECT_EQ(marked("1 μm or less"), "1 μm or less");
  EXPECT_EQ(marked("time (µs a frame)"), "time (µs a frame)");
  EXPECT_EQ(marked("tension 0.2 m·g"), "tension 0.2 ⟨m⟩·⟨g⟩");
}

TEST(Mathematics, WordsFunctionsAndTransposesAreUpright) {
  EXPECT_EQ(marked("a row of J"), "a row of ⟨J⟩");
  EXPECT_EQ(marked("a_2 < 0: a clockwise arrow"), "⟨a⟩2 < 0: a clockwise arrow");
  EXPECT_EQ(marked("the joint's J^T"), "the joint's ⟨J⟩T");
  EXPECT_EQ(marked("tanθ = μ"), "tan⟨θ⟩ = ⟨μ⟩");
  EXPECT_EQ(marked("ln 2/h"), "ln 2/⟨h⟩");
  EXPECT_EQ(marked("ω_{max} h = 2"), "⟨ω⟩max ⟨h⟩ = 2");
  EXPECT_EQ(marked("Gauss–Seidel, N = 10"), "Gauss–Seidel, ⟨N⟩ = 10");
  EXPECT_EQ(marked("cost and Box2D 3, 2D and 2v"), "cost and Box2D 3, 2⟨D⟩ and 2⟨v⟩");
  EXPECT_EQ(marked("ΔE/(m·g·L)"), "Δ⟨E⟩/(⟨m⟩·⟨g⟩·⟨L⟩)");
}

TEST(Mathematics, NoLabelIsTooOdd) {
  for (const char* label : {"", "_", "^", "(", "()", "1 ", "a", "1 (", "_{", "^{m", "\\", "(m", "2 m/"})
    marked(label);
}

}  // namespace
}  // namespace byhand::renderer
