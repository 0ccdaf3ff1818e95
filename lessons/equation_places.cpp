#include "lessons/page/equation_places.hpp"

namespace byhand::course {

const std::array<EquationPlace, 23> equation_places{{
    {1, "1", "a constraint is a function of two poses that is zero"},
    {1, "1", "a rod keeps two points at a distance"},
    {1, "2", "then its rate is zero as well"},
    {1, "2", "the rate is a row times the velocities"},
    {1, "2", "a force along the row does what the row asks for"},
    {1, "2", "the four parts of J"},
    {1, "2", "JV as a product of matrices"},
    {1, "2", "JV part by part"},
    {1, "3", "the rod, differentiated"},
    {1, "3", "with the velocities of the two points"},
    {1, "4", "d, from one point to the other"},
    {1, "4", "multiplied out"},
    {1, "4", "with the angular velocities isolated"},
    {1, "5", "J of the rod"},
    {1, "7", "J of a contact"},
    {1, "7b", "J of friction"},
    {2, "3", "λ of one row"},
    {2, "2", "the inverse masses of two bodies"},
    {2, "2", "JM⁻¹Jᵀ, the inverse effective mass"},
    {2, "4", "the impulse λJᵀ changes the velocities"},
    {4, "2", "the rate with a bias"},
    {4, "2", "Baumgarte's bias"},
    {1, "7c", "the separation of a contact"},
}};

}  // namespace byhand::course
