#include "base/result.hpp"

#include <catch2/catch.hpp>

#include <memory>

namespace tuberia {

namespace {

Result<int> half_of(int number) {
  if (number % 2 != 0) return Error{"number is " + std::to_string(number) + ", but must be even"};
  return number / 2;
}

}  // namespace

TEST_CASE("result: holds either the value or the error", "[base]") {
  const auto good = half_of(8);
  CHECK(good.ok());
  CHECK(good);
  CHECK(*good == 4);
  CHECK(good.value() == 4);

  const auto bad = half_of(7);
  CHECK_FALSE(bad.ok());
  CHECK_FALSE(bad);
  CHECK(bad.error().message == "number is 7, but must be even");
}

TEST_CASE("result: a value that cannot be copied can be moved out", "[base]") {
  Result<std::unique_ptr<int>> made = std::make_unique<int>(5);
  REQUIRE(made.ok());
  CHECK(**made == 5);
  const std::unique_ptr<int> taken = std::move(made).value();
  CHECK(*taken == 5);
}

TEST_CASE("result: the value can be changed in place", "[base]") {
  Result<std::string> text = std::string("edge");
  text->append(" function");
  *text += "!";
  CHECK(text.value() == "edge function!");
}

TEST_CASE("result: work without a value still reports whether it was done", "[base]") {
  const Result<Nothing> done = Nothing{};
  const Result<Nothing> refused = Error{"no"};
  CHECK(done.ok());
  CHECK_FALSE(refused.ok());
}

}  // namespace tuberia
