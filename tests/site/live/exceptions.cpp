// Exceptions in WebAssembly, which Debian's libc++abi leaves out there (lessons/site/live/exceptions.cpp).

#include <gtest/gtest.h>

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

struct Counted {
  explicit Counted(int& count) : count_(&count) { ++*count_; }
  Counted(const Counted& other) : count_(other.count_) { ++*count_; }
  ~Counted() { --*count_; }
  int* count_;
};

struct First {
  virtual ~First() = default;
  int first = 1;
};
struct Second {
  virtual ~Second() = default;
  int second = 2;
};
struct Both : First, Second {};

TEST(Exceptions, AreCaughtByTheFirstHandlerThatFits) {
  std::string caught;
  try {
    throw std::invalid_argument("beta");
  } catch (const std::out_of_range&) {
    caught = "another";
  } catch (const std::logic_error& error) {
    caught = error.what();
  } catch (...) {
    caught = "anything";
  }
  EXPECT_EQ(caught, "beta");
}

TEST(Exceptions, DestroyWhatTheyLeave) {
  int alive = 0;
  try {
    const Counted outer(alive);
    [&] {
      const Counted inner(alive);
      throw 1;
    }();
  } catch (int) {
    EXPECT_EQ(alive, 0);
  }
}

TEST(Exceptions, ArePassedOnAndDestroyedOnce) {
  int alive = 0;
  try {
    try {
      throw Counted(alive);
    } catch (Counted&) {
      EXPECT_EQ(alive, 1);
      throw;
    }
  } catch (const Counted&) {
    EXPECT_EQ(alive, 1);
  }
  EXPECT_EQ(alive, 0);
}

TEST(Exceptions, MayBeThrownWhileOthersAreHandled) {
  std::string order;
  try {
    try {
      throw std::string("outer");
    } catch (const std::string& outer) {
      try {
        throw 2;
      } catch (int) {
        order += "inner ";
      }
      order += outer;
      throw 3.0;
    }
  } catch (double) {
    order += " next";
  }
  EXPECT_EQ(order, "inner outer next");
}

TEST(Exceptions, AreCaughtAsAnyOfTheirBases) {
  try {
    throw Both{};
  } catch (const Second& second) {
    EXPECT_EQ(second.second, 2);
  }
  Both both;
  try {
    throw static_cast<First*>(&both);
  } catch (const First* first) {
    EXPECT_EQ(first->first, 1);
  }
}

TEST(Exceptions, CanBeKeptAndThrownLater) {
  std::exception_ptr kept;
  try {
    throw std::runtime_error("kept");
  } catch (...) {
    kept = std::current_exception();
  }
  for (int i = 0; i < 2; ++i) {
    try {
      std::rethrow_exception(kept);
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "kept");
    }
  }
}

}  // namespace
