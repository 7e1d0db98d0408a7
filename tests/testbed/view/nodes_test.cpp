// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Node selection and layer names: every form is read, named back and applied; everything else is refused with the
// forms listed.

#include "testbed/view/nodes.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

TEST(Nodes, NamesReadBack) {
    for (const char* name : {"internal", "leaves", "all", "level=0", "level=12", "levels=2..5"}) {
        EXPECT_EQ(GetNodeSelectionName(ParseNodeSelection(name)), name);
    }
    for (const char* bad : {"", "Internal", "level=", "level=-1", "level=x", "levels=3", "levels=3..", "levels=5..2",
                            "levels=1..2..3", "level=1 "}) {
        EXPECT_THROW((void)ParseNodeSelection(bad), std::invalid_argument) << bad;
    }
}

TEST(Nodes, InternalAndLeavesShareOutTheTree) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    EXPECT_EQ(SelectBoxes(snapshot, ParseNodeSelection("internal")).size(), 31u);
    EXPECT_EQ(SelectBoxes(snapshot, ParseNodeSelection("leaves")).size(), 32u);
    EXPECT_EQ(SelectBoxes(snapshot, ParseNodeSelection("all")).size(), 63u);
    EXPECT_EQ(SelectBoxes(snapshot, ParseNodeSelection("level=0")).size(), 1u);
    EXPECT_EQ(SelectBoxes(snapshot, ParseNodeSelection("levels=1..2")).size(), 6u);
    EXPECT_EQ(SelectBoxes(snapshot, ParseNodeSelection("level=99")).size(), 0u);
}

}  // namespace
}  // namespace testbed
