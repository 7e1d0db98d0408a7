// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// FunctionRef: calls what it was made from, of any kind, and tells nothing from something.

#include "scree/function_ref.h"

#include <gtest/gtest.h>

#include <memory>

namespace scree::test {
namespace {

int Twice(int x) { return 2 * x; }

int Apply(FunctionRef<int(int)> f, int x) { return f == nullptr ? -1 : f(x); }

struct Counter {
    int calls = 0;
    int operator()(int x) { return calls++, x; }
};

TEST(FunctionRef, CallsFunctionsLambdasObjectsAndStdFunctions) {
    EXPECT_EQ(Apply(Twice, 4), 8);
    EXPECT_EQ(Apply(&Twice, 4), 8);
    const int a = 1, b = 2, c = 3, d = 4;
    EXPECT_EQ(Apply([&](int x) { return a + b + c + d + x; }, 5), 15);
    const std::function<int(int)> owned = [a, b](int x) { return x - a - b; };
    EXPECT_EQ(Apply(owned, 5), 2);
    Counter counter;
    EXPECT_EQ(Apply(counter, 7), 7);
    EXPECT_EQ(counter.calls, 1) << "it was not copied";
}

TEST(FunctionRef, KnowsNothing) {
    EXPECT_EQ(Apply(nullptr, 4), -1);
    EXPECT_EQ(Apply(std::function<int(int)>(), 4), -1);
    int (*none)(int) = nullptr;
    EXPECT_EQ(Apply(none, 4), -1);
    EXPECT_TRUE(FunctionRef<int(int)>() == nullptr);
}

TEST(FunctionRef, PassesReferencesAndMoveOnlyValuesThrough) {
    int target = 0;
    const auto raise = [](int& x, std::unique_ptr<int> by) { x += *by; };
    FunctionRef<void(int&, std::unique_ptr<int>)> f = raise;
    f(target, std::make_unique<int>(3));
    EXPECT_EQ(target, 3);
    static_assert(sizeof(f) == 2 * sizeof(void*));
}

}  // namespace
}  // namespace scree::test
