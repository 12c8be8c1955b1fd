#include "base/nearest_name.hpp"

#include <gtest/gtest.h>

namespace ashlar {
namespace {

const std::vector<std::string> keys{"young", "poisson", "density", "tensile_strength", "x"};

TEST(nearest_name, one_edit_is_forgiven_in_any_word) {
  EXPECT_EQ(nearest_name("yuong", keys), "young");
  EXPECT_EQ(nearest_name("densty", keys), "density");
  EXPECT_EQ(nearest_name("poissons", keys), "poisson");
}

TEST(nearest_name, longer_words_may_be_further_off) {
  EXPECT_EQ(nearest_name("tensil_strenght", keys), "tensile_strength");  // 15 letters: up to 4 edits
  EXPECT_EQ(nearest_name("dns", keys), "");
}

TEST(nearest_name, a_single_letter_is_not_corrected_into_another) { EXPECT_EQ(nearest_name("y", keys), ""); }

TEST(nearest_name, distance_is_symmetric_and_zero_for_equal_words) {
  EXPECT_EQ(edit_distance("dam", "dam"), 0);
  EXPECT_EQ(edit_distance("rock", "dam_rock"), 4);
  EXPECT_EQ(edit_distance("dam_rock", "rock"), 4);
  EXPECT_EQ(edit_distance("ab", "ba"), 1);
}

TEST(nearest_name, a_message_lists_what_is_valid_where_nothing_is_near) {
  EXPECT_EQ(suggest_name("yong", keys), ": did you mean 'young'?");
  EXPECT_EQ(suggest_name("colour", keys), "; valid: young, poisson, density, tensile_strength, x");
  EXPECT_EQ(suggest_name("dam", {}), "; there are none");
}

}  // namespace
}  // namespace ashlar
