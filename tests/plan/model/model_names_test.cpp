#include "plan/model/model_names.hpp"

#include <gtest/gtest.h>

#include "changeover/io/input.hpp"
#include "changeover/plan/model.hpp"

namespace changeover::model_names_test {
namespace {

// A sheet of what was done has the whole name in the column of the parameter.
TEST(ModelNames, AValueMayHaveTheNameOfItsParameterBeforeIt) {
  const Model model =
      read_model(*input_from_text("Log: On, Off\nRetry: On, Off\nURL: a:b, URL=c\n", "m.txt"));
  const ModelNames names(model);
  const std::size_t retry = 1;
  const auto on = names.value(retry, "On");
  ASSERT_TRUE(on);
  for (const char* text : {"Retry: On", "retry=on", "Retry: Retry: On"}) {
    EXPECT_EQ(names.value(retry, text), on) << text;
  }
  EXPECT_FALSE(names.value(retry, "Log: On"));  // of another parameter
  EXPECT_FALSE(names.value(retry, "Retry: Never"));
  EXPECT_EQ(names.without_parameter(retry, "Retry: Never"), "Never");
  EXPECT_EQ(names.without_parameter(retry, "Log: On"), "Log: On");
  // A value that is called so itself.
  EXPECT_TRUE(names.value(2, "a:b"));
  EXPECT_TRUE(names.value(2, "URL=c"));
  EXPECT_TRUE(names.value(2, "URL: URL=c"));
}

}  // namespace
}  // namespace changeover::model_names_test
