// What a call that must fail says, and whether the message has all its parts.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace swellflow_test {

template <typename Call>
std::string complaint_of(const Call &call)
{
  try {
    call();
  } catch (const std::invalid_argument &problem) {
    return problem.what();
  }
  return "no error";
}

inline void expect_all(const std::string &message, const std::vector<std::string> &parts)
{
  for (const std::string &part : parts) EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

}  // namespace swellflow_test
