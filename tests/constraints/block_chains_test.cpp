// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whatever the threads do first, no two of them push a body at once, and every body meets its contacts in the order of
// passes and colours. Where passes end with the bodies, each is visited after all its contacts. Slices: even, in order,
// and where few contacts are between them.

#include "constraints/block_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "constraints/body_slices.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {
namespace {

using namespace test;

/// One contact a block; the bodies are in as many slices as there are chains.
struct ChainCase {
    struct Block {
        int a, b, colour;
    };
    int bodies, chains;
    std::vector<int> slice;  ///< by body
    std::vector<Block> blocks;
    std::vector<BlockChains::Section> sections;
    std::vector<BlockRange> groups;

    explicit ChainCase(std::mt19937& random) {
        const auto any = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
        bodies = any(2, 60);
        chains = any(2, 6);
        slice.resize(ToSize(bodies));
        for (int& s : slice) s = any(0, chains - 1);
        std::vector<std::set<int>> taken(ToSize(bodies));
        std::vector<uint8_t> isAtBorder(ToSize(bodies));
        std::vector<Block> found;
        int colourCount = 0;
        const bool isLocal = any(0, 1) == 0;
        for (int i = any(0, 150); i > 0; --i) {
            const int a = any(0, bodies - 1), b = any(0, bodies - 1);
            if (a == b || (isLocal && slice[ToSize(a)] != slice[ToSize(b)] && any(0, 9) > 0)) continue;
            int colour = 0;
            while (taken[ToSize(a)].contains(colour) || taken[ToSize(b)].contains(colour)) ++colour;
            taken[ToSize(a)].insert(colour), taken[ToSize(b)].insert(colour);
            colourCount = std::max(colourCount, colour + 1);
            found.push_back({a, b, colour});
            if (slice[ToSize(a)] != slice[ToSize(b)]) isAtBorder[ToSize(a)] = isAtBorder[ToSize(b)] = 1;
        }
        for (int colour = 0; colour < colourCount; ++colour) {
            for (const bool twoPoints : {false, true}) {
                const int first = static_cast<int>(blocks.size());
                for (int chain = 0; chain < chains; ++chain) {
                    const auto add = [&](bool border) {
                        for (size_t i = 0; i < found.size(); ++i) {
                            const Block& f = found[i];
                            const bool isBorder = isAtBorder[ToSize(f.a)] != 0 || isAtBorder[ToSize(f.b)] != 0;
                            if (f.colour == colour && (i % 2 == 1) == twoPoints && slice[ToSize(f.b)] == chain &&
                                isBorder == border)
                                blocks.push_back(f);
                        }
                        return static_cast<int>(blocks.size());
                    };
                    const int begin = static_cast<int>(blocks.size());
                    const int border = add(true);
                    sections.push_back({begin, border, add(false)});
                }
                groups.push_back({first, static_cast<int>(blocks.size()), {false, twoPoints}, colour});
            }
        }
    }
};

/// Chains whose steps are begun and ended in any order that the needs allow.
class AnySchedule {
public:
    AnySchedule(const ChainCase& given, const BlockChains& chains, int passes, bool withBodies)
        : m_case(given),
          m_chains(chains),
          m_passes(passes),
          m_withBodies(withBodies),
          m_done(ToSize(chains.Count())),
          m_isAtWork(ToSize(chains.Count())),
          m_last(ToSize(given.bodies), -1),
          m_holder(ToSize(given.bodies), -1) {}

    void Run(std::mt19937& random) {
        const int64_t steps = m_passes * int64_t{CountSteps()};
        int64_t ended = 0;
        while (ended < steps) {
            std::vector<int> able;
            for (int chain = 0; chain < m_chains.Count(); ++chain) {
                if (m_isAtWork[ToSize(chain)] || MayBegin(chain)) able.push_back(chain);
            }
            ASSERT_FALSE(able.empty()) << "all wait for each other";
            const int chain = able[random() % able.size()];
            ended += m_isAtWork[ToSize(chain)] ? 1 : 0;
            m_isAtWork[ToSize(chain)] ? End(chain) : Begin(chain);
            if (testing::Test::HasFailure()) return;
        }
        const int64_t visits = m_withBodies ? m_case.bodies : 0;
        ASSERT_EQ(m_pushed, m_passes * (2 * static_cast<int64_t>(m_case.blocks.size()) + visits));
    }

private:
    [[nodiscard]] int CountSteps() const {
        int steps = 0;
        for (int chain = 0; chain < m_chains.Count(); ++chain) steps += StepsOf(chain);
        return steps;
    }
    [[nodiscard]] int StepsOf(int chain) const { return m_chains.CountSteps(chain, m_withBodies); }
    [[nodiscard]] bool MayBegin(int chain) const {
        const int done = m_done[ToSize(chain)];
        if (done == m_passes * StepsOf(chain)) return false;
        for (int other = 0; other < m_chains.Count(); ++other) {
            if (m_done[ToSize(other)] < m_chains.CountNeeded(chain, done, other, m_withBodies)) return false;
        }
        return true;
    }
    /// Calls visit(body, colour) for the next step of a chain. Bodies that are visited by themselves have the last one.
    template <typename Visit>
    void ForEachBody(int chain, Visit&& visit) {
        const std::span<const BlockChains::Step> steps = m_chains.GetSteps(chain);
        const size_t index = ToSize(m_done[ToSize(chain)] % StepsOf(chain));
        if (index == steps.size()) {
            for (int body = 0; body < m_case.bodies; ++body) {
                if (m_case.slice[ToSize(body)] == chain) visit(body, 999);
            }
            return;
        }
        const BlockChains::Step& step = steps[index];
        for (int r = step.firstRange; r < step.endRange; ++r) {
            const BlockRange& range = m_chains.GetRange(r);
            for (int k = range.begin; k < range.end; ++k) {
                const ChainCase::Block& block = m_case.blocks[ToSize(k)];
                EXPECT_EQ(block.colour, range.colour);
                visit(block.a, block.colour), visit(block.b, block.colour);
            }
        }
    }
    void Begin(int chain) {
        m_isAtWork[ToSize(chain)] = true;
        const int pass = m_done[ToSize(chain)] / StepsOf(chain);
        ForEachBody(chain, [&](int body, int colour) {
            EXPECT_EQ(m_holder[ToSize(body)], -1) << "body " << body << " is pushed by two threads";
            m_holder[ToSize(body)] = chain;
            EXPECT_LT(m_last[ToSize(body)], pass * 1000 + colour) << "body " << body;
            m_last[ToSize(body)] = pass * 1000 + colour;
            ++m_pushed;
        });
    }
    void End(int chain) {
        ForEachBody(chain, [&](int body, int) { m_holder[ToSize(body)] = -1; });
        m_isAtWork[ToSize(chain)] = false;
        ++m_done[ToSize(chain)];
    }

    const ChainCase& m_case;
    const BlockChains& m_chains;
    int m_passes;
    bool m_withBodies;
    std::vector<int> m_done;
    std::vector<bool> m_isAtWork;
    std::vector<int> m_last;    ///< by body: pass · 1000 + colour of the last push
    std::vector<int> m_holder;  ///< by body: the chain that pushes it, −1 if none
    int64_t m_pushed = 0;
};

TEST(BlockChains, BodiesMeetTheirContactsInTheOrderOfColours) {
    std::mt19937 random(20);
    int waiting = 0;
    for (int i = 0; i < 400; ++i) {
        const ChainCase given(random);
        BlockChains chains;
        chains.Build(given.chains, given.sections, given.groups);
        ASSERT_EQ(chains.Count(), given.chains);
        for (int chain = 0; chain < chains.Count(); ++chain) {
            for (const BlockChains::Step& step : chains.GetSteps(chain)) waiting += step.needs >= 0 ? 1 : 0;
        }
        AnySchedule(given, chains, 1 + static_cast<int>(random() % 3), i % 2 == 1).Run(random);
        ASSERT_FALSE(HasFailure()) << "case " << i;
    }
    EXPECT_GT(waiting, 1000);
}

std::vector<ContactIndex> AllContacts(const WorldState& s) {
    std::vector<ContactIndex> list;
    for (const ContactIndex c : s.contacts.Rows()) {
        if (s.contacts.IsAlive(c)) list.push_back(c);
    }
    return list;
}

/// Boxes side by side in rows, made in order or in any.
void MakeWall(World& world, int width, int height, bool isMixed, std::mt19937& random) {
    std::vector<int> places(ToSize(width * height));
    std::iota(places.begin(), places.end(), 0);
    if (isMixed) std::shuffle(places.begin(), places.end(), random);
    for (const int place : places) {
        const Vec2 at{static_cast<float>(place % width), static_cast<float>(place / width)};
        AddBox(AddBody(world, dynamicBody, at), 0.5f, 0.5f);
    }
    world.Step(1.0f / 60.0f, 8, 3);
}

TEST(BodySlices, AreEvenAndCutFewContacts) {
    std::mt19937 random(3);
    for (const bool isMixed : {false, true}) {
        for (int i = 0; i < 6; ++i) {
            const int workers = 2 + static_cast<int>(random() % 4);  // from four on lists are sorted in parts
            const int length = 80 + static_cast<int>(random() % 80), breadth = 8 + static_cast<int>(random() % 8);
            const bool isHigh = random() % 2 == 0;
            World world(vec2Zero);
            MakeWall(world, isHigh ? breadth : length, isHigh ? length : breadth, isMixed, random);
            const WorldState& s = world.GetState();
            const std::vector<ContactIndex> list = AllContacts(s);
            TaskPool pool(workers, {});
            BodySlices slices;
            slices.Update(pool, s.bodies, s.contacts, list);
            EXPECT_EQ(slices.Count(), 1) << "the pool shares nothing now";
            pool.Begin();
            slices.Update(pool, s.bodies, s.contacts, list);
            pool.End();
            ASSERT_EQ(slices.Count(), workers);
            std::vector<int> sizes(ToSize(workers));
            int cut = 0;
            for (const ContactIndex c : list) {
                const ContactPair& pair = s.contacts.pair[c];
                ++sizes[slices.Of(s.bodies, pair.bodyB)];
                cut += slices.Of(s.bodies, pair.bodyA) != slices.Of(s.bodies, pair.bodyB) ? 1 : 0;
            }
            const int even = static_cast<int>(list.size()) / workers;
            for (const int size : sizes) EXPECT_NEAR(size, even, even / 3);
            // A cut across the wall is 16 bodies long at most; each has 3 contacts with those beyond.
            EXPECT_LE(cut, 8 * 16 * (workers - 1)) << (isMixed ? "mixed " : "in order ") << (isHigh ? "high" : "long");

            std::vector<BodyIndex> all, scratch;
            for (const BodyIndex body : s.bodies.slots.Rows()) all.push_back(body);
            pool.Begin();
            const std::span<const BodyIndex> sorted = slices.Sort(pool, s.bodies, all, scratch);
            pool.End();
            std::ranges::stable_sort(
                all, [&](BodyIndex a, BodyIndex b) { return slices.Of(s.bodies, a) < slices.Of(s.bodies, b); });
            EXPECT_TRUE(std::ranges::equal(sorted, all));
        }
    }
}

TEST(BodySlices, StayUntilTheyAreUneven) {
    std::mt19937 random(4);
    World world(vec2Zero);
    MakeWall(world, 120, 10, true, random);
    const WorldState& s = world.GetState();
    std::vector<ContactIndex> list = AllContacts(s);
    TaskPool pool(2, {});
    pool.Begin();
    BodySlices slices;
    slices.Update(pool, s.bodies, s.contacts, list);
    ASSERT_EQ(slices.Count(), 2);
    const auto sizeOfFirst = [&] {
        return std::ranges::count_if(
            list, [&](ContactIndex c) { return slices.Of(s.bodies, s.contacts.pair[c].bodyB) == 0; });
    };
    // Of the second slice every other contact goes.
    std::erase_if(
        list, [&](ContactIndex c) { return slices.Of(s.bodies, s.contacts.pair[c].bodyB) == 1 && ToInt(c) % 2 == 0; });
    const ptrdiff_t before = sizeOfFirst();
    slices.Update(pool, s.bodies, s.contacts, list);
    EXPECT_EQ(sizeOfFirst(), before) << "nobody has told";
    const int first = static_cast<int>(before), second = static_cast<int>(list.size()) - first;
    slices.Note(std::array{first, second}, 0);
    const int edition = slices.GetEdition();
    int steps = 0;
    for (; steps < 20 && slices.GetEdition() == edition; ++steps) slices.Update(pool, s.bodies, s.contacts, list);
    EXPECT_LT(steps, 10);
    EXPECT_LT(sizeOfFirst(), before);
    EXPECT_NEAR(static_cast<double>(sizeOfFirst()), 0.5 * static_cast<double>(list.size()),
                0.15 * static_cast<double>(list.size()));

    // Where cutting does not help, it is tried ever more seldom.
    const int editions = slices.GetEdition();
    for (int i = 0; i < 2000; ++i) {
        slices.Note(std::array{3 * first, first}, 0);
        slices.Update(pool, s.bodies, s.contacts, list);
    }
    EXPECT_GE(slices.GetEdition(), editions + 4);
    EXPECT_LE(slices.GetEdition(), editions + 20);
    pool.End();
}

TEST(BodySlices, AreNoneForSomeStepsWhereNothingWasLaidOutByThem) {
    std::mt19937 random(5);
    World world(vec2Zero);
    MakeWall(world, 120, 10, false, random);
    const WorldState& s = world.GetState();
    const std::vector<ContactIndex> list = AllContacts(s);
    TaskPool pool(2, {});
    pool.Begin();
    BodySlices slices;
    int cuts = 0, last = 0, longest = 0;
    for (int i = 0, since = 0; i < 1000; ++i) {
        slices.Update(pool, s.bodies, s.contacts, list);
        longest = std::max(longest, ++since);
        if (slices.Count() == 1) continue;
        EXPECT_NE(slices.GetEdition(), last);
        last = slices.GetEdition();
        ++cuts;
        since = 0;
        slices.NoteUnused();
        EXPECT_EQ(slices.Count(), 1);
    }
    pool.End();
    EXPECT_GE(cuts, 6);
    EXPECT_LE(cuts, 12);
    EXPECT_LE(longest, 257);
}

TEST(BodySlices, AreNoneWhereAllTouchAll) {
    World world(vec2Zero);
    for (int i = 0; i < 60; ++i)
        AddCircle(AddBody(world, dynamicBody, {0.01f * static_cast<float>(i * 37 % 60), 0.0f}), 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    const WorldState& s = world.GetState();
    const std::vector<ContactIndex> list = AllContacts(s);
    ASSERT_GT(list.size(), 1024u);
    TaskPool pool(2, {});
    pool.Begin();
    BodySlices slices;
    slices.Update(pool, s.bodies, s.contacts, list);
    pool.End();
    EXPECT_EQ(slices.Count(), 1);
}

}  // namespace
}  // namespace scree
