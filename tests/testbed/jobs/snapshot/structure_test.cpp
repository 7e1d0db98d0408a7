// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The compact structure of a snapshot: every change of a body, node or contact is found and named, and nothing else.

#include "testbed/jobs/snapshot/structure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

using Json = nlohmann::ordered_json;

Json Compare(const Snapshot& expected, const Snapshot& actual) {
    return CompareStructures(DescribeStructure(expected), DescribeStructure(actual));
}

/// changed, added, removed.
void ExpectCounts(const Json& kind, int changed, int added, int removed) {
    EXPECT_EQ(kind["changed"], changed) << kind;
    EXPECT_EQ(kind["added"], added) << kind;
    EXPECT_EQ(kind["removed"], removed) << kind;
}

TEST(Structure, OfTheSameSnapshotIsEqual) {
    const Snapshot snapshot = MakeSampleSnapshot(6, 4, "scree");
    const Json found = Compare(snapshot, snapshot);
    EXPECT_TRUE(found["equal"].get<bool>());
    for (const char* kind : {"bodies", "nodes", "contacts"}) ExpectCounts(found[kind], 0, 0, 0);
}

TEST(Structure, NegativeZeroIsZero) {
    Snapshot expected = MakeSampleSnapshot(3, 3, "scree"), actual = expected;
    expected.bodies[4].linearVelocity.x = 0.0f;
    actual.bodies[4].linearVelocity.x = -0.0f;
    EXPECT_TRUE(Compare(expected, actual)["equal"].get<bool>());
}

TEST(Structure, ABodyMovedByTheLeastAmountIsFound) {
    const Snapshot expected = MakeSampleSnapshot(6, 4, "scree");
    for (std::size_t i = 0; i < expected.bodies.size(); ++i) {
        Snapshot actual = expected;
        actual.bodies[i].position.y = std::nextafter(actual.bodies[i].position.y, 1e9f);
        const Json found = Compare(expected, actual);
        EXPECT_FALSE(found["equal"].get<bool>());
        ExpectCounts(found["bodies"], 1, 0, 0);
        EXPECT_EQ(found["bodies"]["list"][0]["index"], i);
        ExpectCounts(found["nodes"], 0, 0, 0);
    }
}

TEST(Structure, PosesAreGivenInMetresAndRadians) {
    Snapshot expected = MakeSampleSnapshot(3, 2, "scree"), actual = expected;
    expected.bodies[3].awake = true;
    actual.bodies[3].position = {1.25f, -7.5f};
    actual.bodies[3].angle = 0.5f;
    actual.bodies[3].awake = false;
    const Json entry = Compare(expected, actual)["bodies"]["list"][0];
    EXPECT_EQ(entry["change"], "changed");
    EXPECT_EQ(entry["expected"]["awake"], true);
    EXPECT_EQ(entry["actual"], (Json{{"x", 1.25}, {"y", -7.5}, {"angle", 0.5}, {"awake", false}}));
}

TEST(Structure, ContactsAndNodesThatComeAndGoAreNamed) {
    const Snapshot expected = MakeSampleSnapshot(4, 3, "scree");
    Snapshot actual = expected;
    const ContactState gone = actual.contacts.front();
    actual.contacts.erase(actual.contacts.begin());
    actual.contacts.back().touching = !actual.contacts.back().touching;
    actual.nodes.pop_back();
    actual.nodes[2].box.upper.x += 1;
    const Json found = Compare(expected, actual);
    ExpectCounts(found["contacts"], 1, 0, 1);
    EXPECT_EQ(found["contacts"]["list"][0]["fixtures"], (Json{gone.fixtureA, gone.fixtureB}));
    EXPECT_EQ(found["contacts"]["list"][0]["actual"], nullptr);
    ExpectCounts(found["nodes"], 1, 0, 1);
    EXPECT_EQ(found["nodes"]["list"][0]["index"], 2);
    ExpectCounts(Compare(actual, expected)["contacts"], 1, 1, 0);
}

TEST(Structure, TheOrderInWhichAnEngineListsContactsDoesNotCount) {
    const Snapshot expected = MakeSampleSnapshot(5, 5, "scree");
    Snapshot actual = expected;
    std::reverse(actual.contacts.begin(), actual.contacts.end());
    EXPECT_TRUE(Compare(expected, actual)["equal"].get<bool>());
}

TEST(Structure, LargeWorldsStaySmallAndStillTellWhere) {
    const Snapshot expected = MakeSampleSnapshot(50, 40, "scree");
    const Json description = DescribeStructure(expected);
    EXPECT_LT(description.dump().size(), 10'000u);
    Snapshot actual = expected;
    actual.bodies[1234].angularVelocity += 1;
    const Json found = Compare(expected, actual);
    const int block = found["bodies"]["block"];
    EXPECT_GT(block, 1);
    ExpectCounts(found["bodies"], block, 0, 0);
    EXPECT_EQ(found["bodies"]["list"][0]["index"], 1234 / block * block);
}

TEST(Structure, DamageIsRefused) {
    const Json good = DescribeStructure(MakeSampleSnapshot(4, 3, "scree"));
    for (const char* pointer : {"/bodies", "/bodies/count", "/nodes/hashes", "/contacts/count"}) {
        Json bad = good;
        bad[Json::json_pointer(pointer)] = "x";
        EXPECT_THROW((void)CompareStructures(good, bad), std::invalid_argument) << pointer;
    }
}

}  // namespace
}  // namespace testbed
