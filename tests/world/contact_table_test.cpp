// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact table against std::map: whatever is added and removed, every pair finds its own row and no other.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "scree/snapshot.h"
#include "state/contacts.h"
#include "tests/world/fixtures.h"

namespace scree {
namespace {

using Key = std::pair<uint32_t, uint32_t>;

ContactIndex Add(ContactTable& table, uint32_t a, uint32_t b, BodyIndex bodyA = BodyIndex{0},
                 BodyIndex bodyB = BodyIndex{1}) {
    return table.Add({FixtureOf(a), FixtureOf(b), bodyA, bodyB});
}
ContactIndex Find(const ContactTable& table, uint32_t a, uint32_t b) { return table.Find(FixtureOf(a), FixtureOf(b)); }

TEST(ContactTable, FindsWhatAMapFinds) {
    EXPECT_TRUE(rc::check("lookup equals std::map", [] {
        const auto range = *rc::gen::inRange<uint32_t>(2, 60);
        const auto actions = *rc::gen::inRange(1, 400);
        ContactTable table;
        std::map<Key, ContactIndex> reference;
        for (int i = 0; i < actions; ++i) {
            const auto a = *rc::gen::inRange<uint32_t>(0, range);
            const auto b = *rc::gen::inRange<uint32_t>(0, range);
            if (a == b) continue;
            const Key key{std::min(a, b), std::max(a, b)};
            const auto found = reference.find(key);
            RC_ASSERT(Find(table, a, b) == (found == reference.end() ? ContactIndex::none : found->second));
            RC_ASSERT(Find(table, b, a) == Find(table, a, b));
            if (found == reference.end()) {
                reference[key] = Add(table, a, b);
            } else {
                table.Remove(found->second);
                reference.erase(found);
                if (i % 5 == 0) table.Compact();
            }
            RC_ASSERT(table.Count() == static_cast<int>(reference.size()));
        }
        for (const auto& [key, row] : reference) RC_ASSERT(Find(table, key.first, key.second) == row);
    }));
}

TEST(ContactTable, LowestFreeRowIsTakenFirstAfterCompact) {
    ContactTable table;
    for (uint32_t i = 0; i < 10; ++i) Add(table, i, i + 100);
    table.Remove(ContactIndex{7});
    table.Remove(ContactIndex{2});
    table.Remove(ContactIndex{9});
    table.Compact();
    EXPECT_EQ(table.Size(), 9);  // the trailing row is gone
    EXPECT_EQ(Add(table, 50, 51), ContactIndex{2});
    EXPECT_EQ(Add(table, 52, 53), ContactIndex{7});
    EXPECT_EQ(Add(table, 54, 55), ContactIndex{9});
}

TEST(ContactTable, ContactsOfABodyAreRowsOfTheTable) {
    EXPECT_TRUE(rc::check("after any additions, removals, rests and compactions", [] {
        const auto actions = *rc::gen::inRange(1, 400);
        const auto asks = *rc::gen::inRange(1, 40);  // seldom: many rows come between two questions
        ContactTable table;
        std::map<Key, ContactIndex> reference;
        for (int i = 0; i < actions; ++i) {
            const auto a = *rc::gen::inRange<uint32_t>(0, 12);
            const auto b = *rc::gen::inRange<uint32_t>(12, 24);
            if (const auto found = reference.find({a, b}); found == reference.end()) {
                reference[{a, b}] = Add(table, a, b, ToIndex<BodyIndex>(a), ToIndex<BodyIndex>(b));
            } else {
                table.Remove(found->second);
                reference.erase(found);
            }
            const auto rested = reference.find({a, *rc::gen::inRange<uint32_t>(12, 24)});
            if (rested != reference.end() && *rc::gen::inRange(0, 3) == 0) table.Rest(rested->second);
            if (*rc::gen::inRange(0, 4) == 0) table.RouseOf(ToIndex<BodyIndex>(a));
            if (*rc::gen::inRange(0, 4) == 0) table.Compact();
            if (*rc::gen::inRange(0, asks) != 0) continue;
            const auto body = *rc::gen::inRange(0, 24);
            std::vector<ContactIndex> listed;
            std::set<ContactIndex, std::greater<>> expected;  // the newest row first
            for (const ContactIndex row : table.OfBody(BodyIndex{body})) {
                RC_ASSERT(row < table.flags.End());
                if (table.IsAlive(row)) listed.push_back(row);
            }
            for (const auto& [key, row] : reference) {
                if (static_cast<int>(key.first) == body || static_cast<int>(key.second) == body) expected.insert(row);
            }
            RC_ASSERT(listed == std::vector(expected.begin(), expected.end()));
            RC_ASSERT(table.CountOfBody(BodyIndex{body}) == static_cast<int>(expected.size()));
        }
    }));
}

TEST(ContactTable, MostlyFreeRowsAreClosedInOrderAndHandlesFollow) {
    constexpr uint32_t count = 6000;
    ContactTable table;
    std::map<Key, Contact*> handles;
    for (uint32_t i = 0; i < count; ++i) {
        const ContactIndex row = Add(table, i, i + count);
        table.manifold[row].localPoint.x = static_cast<float>(i);
        if (i % 7 < 3 && i < 4000) handles[{i, i + count}] = table.Handle(nullptr, row);
    }
    const auto number = [&](uint32_t i) { return table.GetNumber(Find(table, i, i + count)); };
    std::map<uint32_t, ContactNumber> numbers;
    const auto stays = [](uint32_t i) { return i % 5 == 2; };
    for (uint32_t i = 0; i < count; ++i) {
        if (!stays(i)) {
            table.Remove(Find(table, i, i + count));
        } else if (i < 3000) {
            numbers[i] = number(i);
        }
    }
    table.order = {ContactIndex{7}, ContactIndex::none, ContactIndex{2}, ContactIndex{3}, ContactIndex{12}};
    table.place[ContactIndex{12}] = 4;
    table.Compact();

    EXPECT_EQ(table.Size(), static_cast<int>(count / 5));
    EXPECT_EQ(table.Count(), table.Size());
    ContactIndex last = ContactIndex::none;
    for (uint32_t i = 0; i < count; ++i) {
        const ContactIndex row = Find(table, i, i + count);
        if (!stays(i)) {
            ASSERT_EQ(row, ContactIndex::none) << i;
            continue;
        }
        ASSERT_GT(row, last) << "the order is as before";
        last = row;
        ASSERT_TRUE(table.IsRowOf(row, FixtureOf(i), FixtureOf(i + count))) << i;
        ASSERT_EQ(table.manifold[row].localPoint.x, static_cast<float>(i));
        const auto handle = handles.find({i, i + count});
        if (handle != handles.end()) {
            ASSERT_EQ(table.Handle(nullptr, row), handle->second) << i;
        }
        if (i < 3000) {
            ASSERT_EQ(number(i), numbers[i]) << i;
        }
    }
    constexpr ContactIndex none = ContactIndex::none;
    EXPECT_EQ(table.order, (std::vector{ContactIndex{1}, none, ContactIndex{0}, none, ContactIndex{2}}));
    EXPECT_EQ(table.place[ContactIndex{2}], 4);
    std::set<Contact*> distinct;
    for (const ContactIndex row : table.Rows()) distinct.insert(table.Handle(nullptr, row));
    EXPECT_EQ(distinct.size(), static_cast<size_t>(table.Size()));
    const ContactIndex end = table.flags.End();
    EXPECT_EQ(Add(table, 1, 2), end) << "there is no gap left";
}

TEST(ContactTable, FewRowsStayWhereTheyAre) {
    ContactTable table;
    for (uint32_t i = 0; i < 4000; ++i) Add(table, i, i + 5000);
    for (uint32_t i = 0; i < 3999; ++i) table.Remove(ToIndex<ContactIndex>(i));
    table.Compact();
    EXPECT_EQ(Find(table, 3999, 8999), ContactIndex{3999});
}

/// Disks on one spot that push each other apart.
void AddCluster(World& world, int count) {
    for (int i = 0; i < count; ++i) {
        Body* body =
            test::AddBody(world, dynamicBody, {0.01f * static_cast<float>(i % 11), 0.01f * static_cast<float>(i / 11)});
        test::AddCircle(body, 0.5f);
    }
}

/// Each contact keeps its handle and its number from begin to end.
struct Witness : ContactListener {
    std::map<Contact*, std::pair<Key, int>> open;
    int ended = 0;

    static Key KeyOf(Contact* c) {
        return {static_cast<uint32_t>(c->GetFixtureA()->GetIndex()),
                static_cast<uint32_t>(c->GetFixtureB()->GetIndex())};
    }
    void BeginContact(Contact* contact) override {
        EXPECT_TRUE(open.emplace(contact, std::pair(KeyOf(contact), contact->GetIndex())).second);
    }
    void EndContact(Contact* contact) override {
        const auto found = open.find(contact);
        ASSERT_NE(found, open.end());
        EXPECT_EQ(found->second, std::pair(KeyOf(contact), contact->GetIndex()));
        open.erase(found);
        ++ended;
    }
};

TEST(ContactTable, HandlesLastWhileAClusterScatters) {
    World watched({0.0f, 0.0f}), plain({0.0f, 0.0f});
    Witness witness;
    watched.SetContactListener(&witness);
    for (World* world : {&watched, &plain}) {
        AddCluster(*world, 110);
        for (int i = 0; i < 40; ++i) world->Step(1.0f / 60.0f, 8, 3);
    }
    EXPECT_GT(witness.ended, 4096);
    EXPECT_LT(static_cast<int>(witness.open.size()), 1000);
    int touching = 0;
    for (Contact* c = watched.GetContactList(); c != nullptr; c = c->GetNext()) {
        if (!c->IsTouching()) continue;
        ++touching;
        ASSERT_TRUE(witness.open.contains(c));
        EXPECT_EQ(witness.open[c].first, Witness::KeyOf(c));
    }
    EXPECT_EQ(touching, static_cast<int>(witness.open.size()));
    for (World* world : {&watched, &plain}) {
        std::vector<int> colours;
        inspect::GetContactColours(*world, colours);
        std::set<std::pair<int, Body*>> pushed;
        int coloured = 0;
        for (Contact* c = world->GetContactList(); c != nullptr; c = c->GetNext()) {
            ASSERT_LT(static_cast<size_t>(c->GetIndex()), colours.size());
            const int colour = colours[static_cast<size_t>(c->GetIndex())];
            EXPECT_EQ(colour >= 0, c->IsTouching());
            if (colour < 0) continue;
            ++coloured;
            for (Fixture* f : {c->GetFixtureA(), c->GetFixtureB()}) {
                EXPECT_TRUE(pushed.emplace(colour, f->GetBody()).second) << "a colour pushes a body once";
            }
        }
        EXPECT_EQ(coloured, touching);
    }
    EXPECT_EQ(inspect::GetStateHash(watched), inspect::GetStateHash(plain)) << "handles change nothing";
}

TEST(ContactTable, AnImageOfAScatteringClusterGoesOnAlike) {
    World world({0.0f, 0.0f});
    AddCluster(world, 110);
    std::vector<std::unique_ptr<World>> copies;  // each taken at another step, all carried on to the last
    for (int step = 0; step < 30; ++step) {
        if (step % 3 == 0) copies.push_back(LoadWorld(SaveWorld(world)));
        world.Step(1.0f / 60.0f, 8, 3);
        for (const std::unique_ptr<World>& copy : copies) copy->Step(1.0f / 60.0f, 8, 3);
        for (size_t i = 0; i < copies.size(); ++i) {
            ASSERT_EQ(inspect::GetStateHash(*copies[i]), inspect::GetStateHash(world)) << step << ", copy " << i;
        }
    }
}

TEST(ContactTable, ABodyWithManyContactsStaysFindable) {
    // All keys share one fixture: a hash that ignored the other would degenerate into one run.
    ContactTable table;
    constexpr uint32_t count = 100000;
    for (uint32_t i = 1; i <= count; ++i) Add(table, 0, i);
    for (uint32_t i = 1; i <= count; ++i) ASSERT_EQ(Find(table, i, 0), ToIndex<ContactIndex>(i - 1));
    EXPECT_EQ(Find(table, 0, count + 1), ContactIndex::none);
}

TEST(ContactTable, ARowTakesAtMost128Bytes) { EXPECT_LE(ContactTable::GetBytesPerRow(), 128u); }

}  // namespace
}  // namespace scree
