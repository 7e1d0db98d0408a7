// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Colouring: every contact once, no body pushed twice in a colour. Kernels: the same bits from every instruction set,
// and a block of one contact against the same arithmetic in double precision.

#include "constraints/contact_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <thread>

#include "pipeline/parts/run_kernel.h"
#include "scree/inspect.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {

extern const ContactKernels baseContactKernels;

namespace {

using namespace test;

/// A heap of boxes and circles on a floor, many on one spot, so that some bodies have more than 64 contacts.
void MakeHeap(World& world, int count, float spread) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-spread, spread);
    AddGround(world);
    for (int i = 0; i < count; ++i) {
        Body* body = AddBody(world, dynamicBody, {place(random), 1.0f + place(random)});
        i % 2 == 0 ? AddBox(body, 0.5f, 0.5f) : AddCircle(body, 0.4f);
    }
    world.Step(1.0f / 60.0f, 8, 3);
    world.Step(1.0f / 60.0f, 8, 3);
}

std::vector<ContactIndex> TouchingContacts(const WorldState& s) {
    std::vector<ContactIndex> list;
    for (const ContactIndex c : s.contacts.Rows()) {
        if (s.contacts.IsAlive(c) && s.contacts.manifold[c].pointCount > 0) list.push_back(c);
    }
    return list;
}

void ExpectProper(const WorldState& s, const std::vector<ContactIndex>& list, std::span<const int> colours) {
    ASSERT_EQ(colours.size(), list.size());
    std::set<std::pair<int, BodyIndex>> pushed;  // (colour, body)
    for (size_t i = 0; i < list.size(); ++i) {
        const ContactPair& pair = s.contacts.pair[list[i]];
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (s.bodies.type[body] != dynamicBody) continue;
            EXPECT_TRUE(pushed.insert({colours[i], body}).second)
                << "contact " << ToInt(list[i]) << " colour " << colours[i];
        }
    }
}

/// What inspect tells after a step: every contact that was solved has a colour, and no colour pushes a body twice.
void ExpectToldColours(const World& world, const std::vector<ContactIndex>& list, int leastColours) {
    std::vector<int> told;
    inspect::GetContactColours(world, told);
    ASSERT_EQ(told.size(), static_cast<size_t>(world.GetState().contacts.Size()));
    std::vector<ContactIndex> solved;
    std::vector<int> colours;
    for (const ContactIndex contact : list) {
        if (told[ToSize(contact)] < 0) continue;
        solved.push_back(contact);
        colours.push_back(told[ToSize(contact)]);
    }
    EXPECT_EQ(static_cast<ptrdiff_t>(solved.size()),
              std::count_if(told.begin(), told.end(), [](int c) { return c >= 0; }));
    EXPECT_EQ(solved.size() > 0, leastColours > 0);
    EXPECT_GE(static_cast<int>(std::set<int>(colours.begin(), colours.end()).size()), leastColours);
    ExpectProper(world.GetState(), solved, colours);
}

TEST(ContactBlocks, InspectTellsTheColoursOfTheLastStep) {
    World world({0.0f, -10.0f});
    MakeHeap(world, 300, 6.0f);
    const auto solvedNow = [&] {
        std::vector<ContactIndex> list;
        for (const Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            if (c->IsTouching()) list.push_back(ContactIndex{c->GetIndex()});
        }
        return list;
    };
    ExpectToldColours(world, solvedNow(), 4);
    world.Step(1.0f / 60.0f, 4);
    ExpectToldColours(world, solvedNow(), 4);

    World small({0.0f, -10.0f});
    AddGround(small);
    AddBox(AddBody(small, dynamicBody, {0.0f, 0.5f}), 0.5f, 0.5f);
    for (int i = 0; i < 2; ++i) small.Step(1.0f / 60.0f, 8, 3);
    std::vector<int> told;
    inspect::GetContactColours(small, told);
    EXPECT_EQ(told, std::vector<int>{-1}) << "small islands are solved contact by contact";
    small.Step(1.0f / 60.0f, 4);
    inspect::GetContactColours(small, told);
    EXPECT_EQ(told, std::vector<int>{0});
}

TEST(ContactBlocks, NoColourPushesABodyTwice) {
    for (const float spread : {0.3f, 3.0f}) {  // the first has bodies with more contacts than a round has colours
        World world({0.0f, -10.0f});
        MakeHeap(world, 150, spread);
        const WorldState& s = world.GetState();
        const std::vector<ContactIndex> list = TouchingContacts(s);
        ContactBlocks blocks;
        BodyMarks marks;
        blocks.Build({*s.pool, s.bodies, s.fixtures, s.contacts, list, 1.0f}, marks);
        ExpectProper(s, list, blocks.GetColours());
        if (spread < 1.0f) {
            EXPECT_GT(blocks.GetColourCount(), 64);
        }
    }
}

/// Bodies B of the lanes in use, range by range.
std::vector<std::vector<int>> BodiesOfRanges(const KernelTask& task) {
    std::vector<std::vector<int>> bodies;
    for (int i = 0; i < task.rangeCount; ++i) {
        std::vector<int>& own = bodies.emplace_back();
        for (int k = task.ranges[i].begin; k < task.ranges[i].end; ++k) {
            const ContactBlock& block = task.blocks[k];
            for (int l = 0; l < blockLanes && block.slot[l] >= 0; ++l) own.push_back(block.bodyB[l]);
        }
    }
    return bodies;
}

TEST(ContactBlocks, ThreadsMeetLikeBodiesInEveryColour) {
    for (const int workers : {2, 3, 8}) {
        std::mt19937 random(static_cast<unsigned>(workers));
        World world({0.0f, -10.0f});
        MakeHeap(world, 900 + static_cast<int>(random() % 300), 9.0f);
        const WorldState& s = world.GetState();
        std::vector<ContactIndex> list = TouchingContacts(s);
        std::shuffle(list.begin(), list.end(), random);
        ASSERT_GT(list.size(), 512u);
        ContactBlocks alone, shared;
        BodyMarks marks;
        Column<BodyIndex, Velocity> velocity = s.bodies.velocity, ofShared = velocity;
        Column<BodyIndex, Velocity> delta(velocity.size());
        alone.Build({*s.pool, s.bodies, s.fixtures, s.contacts, list, 1.0f}, marks);
        TaskPool pool(workers, {});
        pool.Begin();
        shared.Build({pool, s.bodies, s.fixtures, s.contacts, list, 1.0f}, marks);
        pool.End();
        EXPECT_TRUE(std::ranges::equal(shared.GetColours(), alone.GetColours()));

        const KernelTask task = alone.Task(velocity, delta), sharedTask = shared.Task(ofShared, delta);
        std::vector<std::vector<int>> listed = BodiesOfRanges(task), ordered = BodiesOfRanges(sharedTask);
        ASSERT_EQ(ordered.size(), listed.size());
        const int quarter = ToInt(s.bodies.slots.Size()) / 4 + 1;
        int steps = 0, steepOfListed = 0;
        for (size_t i = 0; i < ordered.size(); ++i) {
            for (size_t k = 1; k < ordered[i].size(); ++k) {
                ++steps;
                EXPECT_GE(ordered[i][k], ordered[i][k - 1] - quarter) << workers << " workers, range " << i;
                steepOfListed += listed[i][k] < listed[i][k - 1] - quarter ? 1 : 0;
            }
            std::ranges::sort(listed[i]), std::ranges::sort(ordered[i]);
        }
        EXPECT_EQ(ordered, listed);
        EXPECT_GT(steepOfListed, steps / 5) << "the list was ordered to begin with";

        GetContactKernels().solveRigid(task), GetContactKernels().solveRigid(sharedTask);
        EXPECT_EQ(std::memcmp(velocity.data(), ofShared.data(), velocity.size() * sizeof(Velocity)), 0);
    }
}

/// By body: the chains whose blocks push it, in and behind their borders.
struct Pushers {
    std::set<int> atBorder, behind;
};

std::map<int, Pushers> PushersOf(const KernelTask& task) {
    std::map<int, Pushers> pushers;
    const std::span<const BlockChains::Section> sections = task.chains->GetSections();
    const int groups = static_cast<int>(sections.size()) / task.chains->Count();
    for (int i = 0; i < static_cast<int>(sections.size()); ++i) {
        const BlockChains::Section& section = sections[ToSize(i)];
        for (int k = section.begin; k < section.end; ++k) {
            const ContactBlock& block = task.blocks[k];
            for (int l = 0; l < blockLanes && block.slot[l] >= 0; ++l) {
                const auto note = [&](int body) {
                    Pushers& of = pushers[body];
                    (k < section.border ? of.atBorder : of.behind).insert(i / groups);
                };
                note(block.bodyB[l]);
                if (block.invMassA[l] > 0.0f) note(block.bodyA[l]);
            }
        }
    }
    return pushers;
}

/// What a program is told of the parts of tasks, by chain: how many have begun and ended.
struct ToldParts {
    std::mutex mutex{};
    std::vector<int> begun{}, ended{};
    int waiting = 0;  ///< parts that had to wait for other chains

    void Note(const TaskPart& part, bool isDone) {
        const std::lock_guard lock(mutex);
        begun.resize(ToSize(part.chainCount)), ended.resize(ToSize(part.chainCount));
        int& count = (isDone ? ended : begun)[ToSize(part.chain)];
        EXPECT_EQ(part.after[part.chain], count) << "parts of a chain follow each other";
        EXPECT_EQ(begun[ToSize(part.chain)], ended[ToSize(part.chain)] + (isDone ? 1 : 0));
        ++count;
        bool waits = false;
        for (int other = 0; other < part.chainCount; ++other) {
            EXPECT_GE(ended[ToSize(other)], part.after[other]);
            waits = waits || (other != part.chain && part.after[other] > 0);
        }
        waiting += waits && isDone ? 1 : 0;
    }
};

/// A program's tasks: on threads of their own, or at once.
TaskCallbacks MakeTasks(ToldParts& told, bool atOnce) {
    TaskCallbacks tasks;
    tasks.enqueue = [](void (*task)(void*), void* taskContext, void*) -> void* {
        return new std::thread(task, taskContext);
    };
    if (atOnce) {
        tasks.enqueue = [](void (*task)(void*), void* taskContext, void*) -> void* {
            task(taskContext);
            return nullptr;
        };
    }
    tasks.finish = [](void* handle, void*) {
        auto* thread = static_cast<std::thread*>(handle);
        thread->join();
        delete thread;
    };
    tasks.part = [](const TaskPart& part, bool isDone, void* context) {
        static_cast<ToldParts*>(context)->Note(part, isDone);
    };
    tasks.context = &told;
    return tasks;
}

TEST(ContactBlocks, ChainsGiveTheBitsOfOneThread) {
    enum class Way : uint8_t { ownThreads, tasksOnThreads, tasksAtOnce };
    struct Case {
        int workers;
        Way way;
    };
    for (const auto [workers, way] : {Case{2, Way::ownThreads},
                                      {3, Way::ownThreads},
                                      {8, Way::ownThreads},
                                      {2, Way::tasksOnThreads},
                                      {5, Way::tasksOnThreads},
                                      {2, Way::tasksAtOnce},
                                      {7, Way::tasksAtOnce}}) {
        std::mt19937 random(static_cast<unsigned>(10 + workers));
        World world({0.0f, -10.0f});
        MakeHeap(world, 1800 + static_cast<int>(random() % 300), 20.0f);
        const WorldState& s = world.GetState();
        const std::vector<ContactIndex> list = TouchingContacts(s);
        ContactBlocks alone, shared;
        BodyMarks marks;
        Column<BodyIndex, Velocity> velocity = s.bodies.velocity, ofShared = velocity;
        Column<BodyIndex, Velocity> delta(velocity.size()), deltaOfShared = delta;
        alone.Build({*s.pool, s.bodies, s.fixtures, s.contacts, list, 1.0f}, marks);
        const KernelTask task = alone.Task(velocity, delta);
        EXPECT_EQ(task.chains, nullptr);

        ToldParts told;
        TaskPool pool(workers, way == Way::ownThreads ? TaskCallbacks{} : MakeTasks(told, way == Way::tasksAtOnce));
        pool.ShareAlways();
        pool.Begin();
        shared.GetSlices().Update(pool, s.bodies, s.contacts, list);
        shared.Build({pool, s.bodies, s.fixtures, s.contacts, list, 1.0f}, marks);
        const KernelTask sharedTask = shared.Task(ofShared, deltaOfShared);
        ASSERT_NE(sharedTask.chains, nullptr);
        EXPECT_EQ(sharedTask.chains->Count(), workers);
        EXPECT_EQ(shared.GetBlockCount(), alone.GetBlockCount());
        EXPECT_TRUE(std::ranges::equal(shared.GetColours(), alone.GetColours()));
        bool anyBehind = false, anyAtBorder = false;
        for (const auto& [body, of] : PushersOf(sharedTask)) {
            EXPECT_LE(of.behind.size(), 1u) << body;
            anyBehind = anyBehind || !of.behind.empty();
            anyAtBorder = anyAtBorder || of.atBorder.size() > 1;
            if (of.atBorder.size() + of.behind.size() < 2) continue;
            std::set<int> all = of.atBorder;
            all.insert(of.behind.begin(), of.behind.end());
            EXPECT_TRUE(all.size() == 1 || of.behind.empty()) << "body " << body << ", " << workers << " workers";
        }
        EXPECT_TRUE(anyBehind && anyAtBorder);

        const ContactKernels& kernels = GetContactKernels();
        constexpr int passes = 5;
        RunKernel(*s.pool, task, kernels.solveRigid, passes), RunKernel(pool, sharedTask, kernels.solveRigid, passes);
        if (way != Way::ownThreads) {
            ASSERT_EQ(told.ended.size(), ToSize(workers));
            for (int chain = 0; chain < workers; ++chain) {
                const size_t steps = sharedTask.chains->GetSteps(chain).size();
                EXPECT_EQ(ToSize(told.ended[ToSize(chain)]), passes * steps);
            }
            EXPECT_GT(told.waiting, passes);
        }
        EXPECT_EQ(std::memcmp(velocity.data(), ofShared.data(), velocity.size() * sizeof(Velocity)), 0);
        for (int i = 0; i < passes; ++i) {
            told.begun.clear(), told.ended.clear();  // each pass is a loop
            EXPECT_EQ(RunPushApart(pool, sharedTask, kernels, 0.2f), RunPushApart(*s.pool, task, kernels, 0.2f));
        }
        EXPECT_EQ(std::memcmp(delta.data(), deltaOfShared.data(), delta.size() * sizeof(Velocity)), 0);
        Column<ContactIndex, Manifold> stored = s.contacts.manifold, storedOfShared = stored;
        alone.Store(1.0f, *s.pool, stored), shared.Store(1.0f, pool, storedOfShared);
        EXPECT_EQ(std::memcmp(stored.data(), storedOfShared.data(), stored.size() * sizeof(Manifold)), 0);
        pool.End();
    }
}

TEST(ContactBlocks, StoreGivesBackWhatWasFilled) {
    World world({0.0f, -10.0f});
    MakeHeap(world, 100, 3.0f);
    WorldState& s = world.GetState();
    const std::vector<ContactIndex> list = TouchingContacts(s);
    ContactBlocks blocks;
    BodyMarks marks;
    blocks.Build({*s.pool, s.bodies, s.fixtures, s.contacts, list, 0.25f}, marks);
    Column<ContactIndex, Manifold> stored = s.contacts.manifold;
    for (Manifold& m : stored) m.points[0].normalImpulse = m.points[1].normalImpulse = -1.0f;
    blocks.Store(4.0f, *s.pool, stored);
    for (const ContactIndex c : list) {
        const Manifold& before = s.contacts.manifold[c];
        const Manifold& after = stored[c];
        for (int p = 0; p < before.pointCount; ++p) {
            EXPECT_EQ(after.points[p].normalImpulse, before.points[p].normalImpulse) << ToInt(c);
        }
    }
}

/// What one lane must hold, by WorldManifold::Initialize; block sides are swapped where B cannot be pushed.
void ExpectFilled(const WorldState& s, ContactIndex c, bool onMoverSurface, const ContactBlock& block, int l) {
    const ContactPair& pair = s.contacts.pair[c];
    const Manifold& m = s.contacts.manifold[c];
    const bool swapped = s.bodies.type[pair.bodyB] != dynamicBody;
    const BodyIndex a = swapped ? pair.bodyB : pair.bodyA, b = swapped ? pair.bodyA : pair.bodyB;
    WorldManifold world;
    world.Initialize(&m, s.bodies.transform[pair.bodyA], s.fixtures.shape[pair.fixtureA]->m_radius,
                     s.bodies.transform[pair.bodyB], s.fixtures.shape[pair.fixtureB]->m_radius);
    const Vec2 normal = swapped ? -world.normal : world.normal, tangent = Cross(normal, 1.0f);
    EXPECT_EQ(block.bodyA[l], ToInt(a));
    EXPECT_EQ(block.bodyB[l], ToInt(b));
    EXPECT_EQ((Vec2{block.normalX[l], block.normalY[l]}), normal);
    const bool atSurface = onMoverSurface && s.bodies.type[a] != dynamicBody;
    Vec2 middle = vec2Zero;
    for (int p = 0; p < m.pointCount; ++p) {
        EXPECT_EQ(block.armA[p][l], Cross(world.points[p] - s.bodies.position[a].c, normal));
        EXPECT_EQ(block.armB[p][l], Cross(world.points[p] - s.bodies.position[b].c, normal));
        EXPECT_EQ(block.separation[p][l], world.separations[p] + linearSlop);
        EXPECT_EQ(block.normalImpulse[p][l], 0.5f * m.points[p].normalImpulse);
        const Vec2 rA = world.points[p] - s.bodies.position[a].c, rB = world.points[p] - s.bodies.position[b].c;
        const Velocity &vA = s.bodies.velocity[a], &vB = s.bodies.velocity[b];
        const float closing = Dot(normal, vB.v + Cross(vB.w, rB) - vA.v - Cross(vA.w, rA));
        const ContactMaterial& material = s.contacts.material[c];
        EXPECT_EQ(block.bias[p][l], closing < -material.restitutionThreshold ? -material.restitution * closing : 0.0f);
        middle += atSurface ? world.points[p] + 0.5f * world.separations[p] * normal : world.points[p];
    }
    if (m.pointCount == 2) middle *= 0.5f;
    EXPECT_EQ(block.tangentArmA[l], Cross(middle - s.bodies.position[a].c, tangent));
    EXPECT_EQ(block.tangentArmB[l], Cross(middle - s.bodies.position[b].c, tangent));
    EXPECT_EQ(block.friction[l], s.contacts.material[c].friction);
    EXPECT_EQ(block.invMassB[l], s.bodies.mass[b].invMass);
    EXPECT_EQ(block.invIB[l], s.bodies.mass[b].invI);
}

TEST(ContactBlocks, FillsWhatTheManifoldsSay) {
    World world({0.0f, -10.0f});
    MakeHeap(world, 200, 4.0f);
    WorldState& s = world.GetState();
    const std::vector<ContactIndex> list = TouchingContacts(s);
    for (size_t i = 0; i < list.size(); i += 2) s.contacts.material[list[i]].restitution = 0.5f;
    for (const bool onMoverSurface : {false, true}) {
        for (const ContactKernels* kernels : {&baseContactKernels, &GetContactKernels()}) {
            ContactBlocks blocks;
            BodyMarks marks;
            blocks.Build({.pool = *s.pool,
                          .bodies = s.bodies,
                          .fixtures = s.fixtures,
                          .contacts = s.contacts,
                          .list = list,
                          .impulseScale = 0.5f,
                          .onMoverSurface = onMoverSurface,
                          .kernels = *kernels},
                         marks);
            Column<BodyIndex, Velocity> unused(s.bodies.velocity.size());
            const KernelTask task = blocks.Task(unused, unused);
            size_t lanes = 0, circles = 0, spare = 0;
            for (int r = 0; r < task.rangeCount; ++r) {
                for (int k = task.ranges[r].begin; k < task.ranges[r].end; ++k) {
                    for (int l = 0; l < blockLanes; ++l) {
                        const ContactBlock& block = task.blocks[k];
                        if (block.slot[l] < 0) {
                            ++spare;
                            EXPECT_EQ(block.invMassA[l] + block.invMassB[l] + block.normalMass[0][l], 0.0f);
                            EXPECT_GT(block.separation[0][l], 0.0f);
                            continue;
                        }
                        const ContactIndex contact = list[static_cast<size_t>(block.slot[l])];
                        ExpectFilled(s, contact, onMoverSurface, block, l);
                        ++lanes;
                        circles += s.contacts.manifold[contact].type == Manifold::e_circles ? 1 : 0;
                    }
                }
            }
            EXPECT_EQ(lanes, list.size());
            EXPECT_GT(circles, 10u);
            EXPECT_GT(spare, 0u);
        }
    }
}

void BuildFor(const ContactKernels& kernels, const WorldState& s, const std::vector<ContactIndex>& list,
              ContactBlocks& blocks) {
    BodyMarks marks;
    blocks.Build({.pool = *s.pool,
                  .bodies = s.bodies,
                  .fixtures = s.fixtures,
                  .contacts = s.contacts,
                  .list = list,
                  .impulseScale = 1.0f,
                  .kernels = kernels},
                 marks);
}

/// All kernels in turn on one copy of the bodies; what they leave behind, as bytes.
std::vector<std::byte> RunAll(const ContactKernels& kernels, const WorldState& s,
                              const std::vector<ContactIndex>& list) {
    ContactBlocks blocks;
    BuildFor(kernels, s, list, blocks);
    Column<BodyIndex, Velocity> velocity = s.bodies.velocity;
    Column<BodyIndex, Velocity> delta(velocity.size());
    KernelTask task = blocks.Task(velocity, delta);
    task.soft = {240.0f, 9.0f, {9.0f, 1.06f}, {12.0f, 1.04f}};
    task.sumImpulses = true;
    kernels.warmStart(task);
    kernels.bounce(task);
    for (int i = 0; i < 3; ++i) {
        kernels.solveRigid(task);
        kernels.pushApart(task, 0.2f);
        kernels.solveSoft(task);
        kernels.relax(task);
    }
    Column<ContactIndex, Manifold> manifold = s.contacts.manifold;
    blocks.Store(1.0f, *s.pool, manifold);
    std::vector<std::byte> bytes;
    const auto append = [&](const void* from, size_t size) {
        const auto* begin = static_cast<const std::byte*>(from);
        bytes.insert(bytes.end(), begin, begin + size);
    };
    append(velocity.data(), velocity.size() * sizeof(Velocity));
    append(delta.data(), delta.size() * sizeof(Velocity));
    for (const Manifold& m : manifold) {
        for (const ManifoldPoint& p : m.points) append(&p.normalImpulse, sizeof(float));
    }
    return bytes;
}

TEST(ContactKernels, EveryInstructionSetGivesTheSameBits) {
    const ContactKernels& best = GetContactKernels();
    for (const float spread : {0.3f, 3.0f}) {
        World world({0.0f, -10.0f});
        MakeHeap(world, 120, spread);
        const WorldState& s = world.GetState();
        const std::vector<ContactIndex> list = TouchingContacts(s);
        ASSERT_GT(list.size(), 100u);
        EXPECT_EQ(RunAll(baseContactKernels, s, list), RunAll(best, s, list)) << best.name;
    }
}

/// After a pass no point of a contact that is alone closes, and none pulls; what pushes does not part.
TEST(ContactKernels, BothPointsOfAContactAreSolvedAtOnce) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    int pushing[3] = {};
    for (int round = 0; round < 400; ++round) {
        World world({0.0f, -10.0f});
        Body* below = AddBody(world, round % 2 == 0 ? staticBody : dynamicBody, {0.0f, 0.0f});
        AddBox(below, 1.0f + 0.5f * any(random), 0.5f);
        Body* above = AddBody(world, dynamicBody, {0.5f * any(random), 0.99f});
        AddBox(above, 0.6f + 0.4f * any(random), 0.5f);
        above->SetLinearVelocity({0.0f, -0.5f + any(random)});
        above->SetAngularVelocity(2.0f * any(random));
        world.Step(0.0f, 8, 3);
        WorldState& s = world.GetState();
        const std::vector<ContactIndex> list = TouchingContacts(s);
        ASSERT_EQ(list.size(), 1u);
        s.contacts.material[list[0]].friction = 0.0f;
        for (const ContactKernels* kernels : {&baseContactKernels, &GetContactKernels()}) {
            ContactBlocks blocks;
            BuildFor(*kernels, s, list, blocks);
            Column<BodyIndex, Velocity> velocity = s.bodies.velocity, delta(velocity.size());
            const KernelTask task = blocks.Task(velocity, delta);
            kernels->relax(task);
            const ContactBlock& block = task.blocks[0];
            const Velocity &a = velocity[BodyIndex{block.bodyA[0]}], &b = velocity[BodyIndex{block.bodyB[0]}];
            int pushes = 0;
            for (int p = 0; p < 2; ++p) {
                const float speed = block.normalX[0] * (b.v.x - a.v.x) + block.normalY[0] * (b.v.y - a.v.y) +
                                    block.armB[p][0] * b.w - block.armA[p][0] * a.w;
                const float impulse = block.normalImpulse[p][0];
                EXPECT_GE(speed, -1e-5f) << round;
                EXPECT_GE(impulse, 0.0f) << round;
                EXPECT_NEAR(impulse * speed, 0.0f, 1e-4f) << round;
                pushes += impulse > 0.0f ? 1 : 0;
            }
            ++pushing[pushes];
        }
    }
    for (const int count : pushing) EXPECT_GT(count, 20);
}

/// What a pass returns is sought over the contacts alone, whichever stand beside: not over lanes to spare, and what is
/// not a number hides nothing.
TEST(ContactKernels, FindTheWorstOfTheContacts) {
    std::mt19937 random(12);
    const auto draw = [&random](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    World world({0.0f, -10.0f});
    MakeHeap(world, 60, 2.0f);
    const WorldState& s = world.GetState();
    std::vector<ContactIndex> all = TouchingContacts(s);
    for (int round = 0; round < 200; ++round) {
        std::shuffle(all.begin(), all.end(), random);
        // A body that is no number makes others so: here each has one contact.
        const bool hasNan = round % 2 == 0;
        std::vector<ContactIndex> list;
        std::set<BodyIndex> used;
        for (const ContactIndex contact : std::span(all).first(1 + random() % 40)) {
            const ContactPair& pair = s.contacts.pair[contact];
            const bool isFree = !used.contains(pair.bodyA) && !used.contains(pair.bodyB);
            if (!hasNan || isFree) list.push_back(contact);
            used.insert({pair.bodyA, pair.bodyB});
        }
        for (const ContactKernels* kernels : {&baseContactKernels, &GetContactKernels()}) {
            ContactBlocks blocks;
            BuildFor(*kernels, s, list, blocks);
            Column<BodyIndex, Velocity> velocity = s.bodies.velocity, delta(velocity.size());
            for (Velocity& motion : delta) {
                motion.v = {draw(-5.0f, 5.0f), draw(-5.0f, 5.0f)}, motion.w = draw(-1.0f, 1.0f);
                if (hasNan && random() % 10 == 0) motion.v.x = nan;
            }
            const KernelTask task = blocks.Task(velocity, delta);
            float smallest = 1.0f, largest = 0.0f;
            for (int r = 0; r < task.rangeCount; ++r) {
                for (int k = task.ranges[r].begin; k < task.ranges[r].end; ++k) {
                    ContactBlock& block = task.blocks[k];
                    for (int lane = 0; lane < blockLanes; ++lane) {
                        block.normalMass[0][lane] = block.normalMass[1][lane] = 0.0f;  // nothing is to move
                        if (block.slot[lane] < 0) continue;
                        const Velocity &a = delta[BodyIndex{block.bodyA[lane]}],
                                       &b = delta[BodyIndex{block.bodyB[lane]}];
                        for (int p = 0; p < (task.ranges[r].kind.twoPoints ? 2 : 1); ++p) {
                            const Vec2 way = b.v - a.v;
                            const float turn = block.armB[p][lane] * b.w - block.armA[p][lane] * a.w;
                            const float apart = block.normalX[lane] * way.x + block.normalY[lane] * way.y + turn;
                            const float separation = block.separation[p][lane];
                            if (separation + apart < smallest) smallest = separation + apart;
                            if (-Max(separation, 0.0f) - apart > largest) largest = -Max(separation, 0.0f) - apart;
                        }
                    }
                }
            }
            EXPECT_NEAR(kernels->pushApart(task, 0.0f), smallest, 1e-5f) << round;
            EXPECT_NEAR(kernels->part(task, Parting{}), largest, 1e-5f) << round;
        }
    }
}

/// The scalar rows, which are compared with Box2D elsewhere, are the oracle of the wide ones: one contact has no order.
TEST(ContactKernels, OneContactEqualsTheScalarRows) {
    for (const bool circle : {true, false}) {
        World world({0.0f, -10.0f});
        Body* ground = AddGround(world);
        ASSERT_NE(ground, nullptr);
        Body* body = AddBody(world, dynamicBody, {0.1f, 0.49f});
        circle ? AddCircle(body, 0.5f) : AddBox(body, 0.5f, 0.5f);
        body->SetLinearVelocity({1.0f, -2.0f});
        body->SetAngularVelocity(0.3f);
        world.Step(0.0f, 8, 3);
        WorldState& s = world.GetState();
        const std::vector<ContactIndex> list = TouchingContacts(s);
        ASSERT_EQ(list.size(), 1u);

        Column<BodyIndex, Velocity> scalar = s.bodies.velocity, wide = scalar, delta(scalar.size());
        ContactRows rows;
        PrepareContacts({s.bodies, s.fixtures, s.contacts, list, 1.0f}, rows);
        ContactBlocks blocks;
        BodyMarks marks;
        blocks.Build({*s.pool, s.bodies, s.fixtures, s.contacts, list, 1.0f}, marks);
        const KernelTask task = blocks.Task(wide, delta);
        for (int i = 0; i < 8; ++i) {
            SolveContactVelocities(rows, scalar);
            GetContactKernels().solveRigid(task);
        }
        // The friction of a box acts in the middle of its points instead of at both. The sum is the same, and so is
        // their torque, as the points are on one line.
        for (const BodyIndex b : scalar.Rows()) {
            EXPECT_NEAR(scalar[b].v.x, wide[b].v.x, 1e-5f) << circle;
            EXPECT_NEAR(scalar[b].v.y, wide[b].v.y, 1e-5f) << circle;
            EXPECT_NEAR(scalar[b].w, wide[b].w, 1e-5f) << circle;
        }
    }
}

}  // namespace
}  // namespace scree
