// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Partitions: a solver's own colours are shown as they are; otherwise every contact it would see gets a colour, and no
// two of one colour share a dynamic body.

#include "testbed/view/islands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

using scenes::BodyType;

/// Bodies of all types, some of their fixtures sensors, and contacts between any two.
Snapshot MakeTangle(int bodies, int contacts) {
    std::mt19937 random(3);
    Snapshot snapshot;
    for (int i = 0; i < bodies; ++i) {
        AddBody(snapshot,
                i % 4 == 0   ? BodyType::isStatic
                : i % 4 == 1 ? BodyType::kinematic
                             : BodyType::dynamic,
                {}, {});
    }
    for (int i = 0; i < contacts; ++i) {
        ContactState contact{};
        contact.fixtureA = static_cast<int>(random() % static_cast<unsigned>(bodies));
        contact.fixtureB = static_cast<int>(random() % static_cast<unsigned>(bodies));
        contact.touching = random() % 4 != 0;
        if (contact.fixtureA != contact.fixtureB) snapshot.contacts.push_back(contact);
    }
    return snapshot;
}

TEST(Partitions, OneColourSharesNoDynamicBody) {
    const Snapshot snapshot = MakeTangle(40, 200);
    const Partitions partitions = FindPartitions(snapshot);
    ASSERT_EQ(partitions.contactColors.size(), snapshot.contacts.size());
    EXPECT_FALSE(partitions.fromEngine);
    EXPECT_EQ(partitions.colorCount,
              *std::max_element(partitions.contactColors.begin(), partitions.contactColors.end()) + 1);
    const auto isDynamic = [](int fixture) { return fixture % 4 >= 2; };
    for (size_t i = 0; i < snapshot.contacts.size(); ++i) {
        const ContactState& a = snapshot.contacts[i];
        const bool isSensor = a.fixtureA % 11 == 10 || a.fixtureB % 11 == 10;
        EXPECT_EQ(partitions.contactColors[i] >= 0, a.touching && !isSensor) << i;
        for (size_t j = 0; j < i; ++j) {
            const ContactState& b = snapshot.contacts[j];
            if (partitions.contactColors[i] < 0 || partitions.contactColors[i] != partitions.contactColors[j]) continue;
            for (const int fixture : {a.fixtureA, a.fixtureB}) {
                EXPECT_FALSE(isDynamic(fixture) && (fixture == b.fixtureA || fixture == b.fixtureB)) << i << " " << j;
            }
        }
    }
}

TEST(Partitions, AChainTakesTwoColoursAndScenerySharesOne) {
    Snapshot snapshot;
    for (int i = 0; i < 6; ++i) AddBody(snapshot, i == 0 ? BodyType::isStatic : BodyType::dynamic, {}, {});
    const auto addContact = [&snapshot](int a, int b) {
        snapshot.contacts.push_back({a, b, true, 1, {}, {}, {}, {}, {}});
    };
    for (int i = 1; i < 5; ++i) addContact(i, i + 1);
    EXPECT_EQ(FindPartitions(snapshot).contactColors, (std::vector<int>{0, 1, 0, 1}));
    snapshot.contacts.clear();
    for (int i = 1; i < 6; ++i) addContact(0, i);
    EXPECT_EQ(FindPartitions(snapshot).contactColors, (std::vector<int>{0, 0, 0, 0, 0}));
}

TEST(Partitions, TheEnginesOwnColoursAreShown) {
    Snapshot snapshot = MakeTangle(10, 20);
    for (size_t i = 0; i < snapshot.contacts.size(); ++i) snapshot.contacts[i].color = static_cast<int>(i % 3) - 1;
    const Partitions partitions = FindPartitions(snapshot);
    EXPECT_TRUE(partitions.fromEngine);
    EXPECT_EQ(partitions.colorCount, 2);
    for (size_t i = 0; i < snapshot.contacts.size(); ++i) {
        EXPECT_EQ(partitions.contactColors[i], static_cast<int>(i % 3) - 1);
    }
}

}  // namespace
}  // namespace testbed
