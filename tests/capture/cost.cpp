// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// capture_cost_ENGINE [STEPS]: what recording takes of the step of a heap of 1,000 bodies that are stirred. It may
// include contacts, or the nodes of the tree. Prints medians of processor time of the thread that steps, and the share.

#ifdef COST_OF_BOX2D
#include <box2d/box2d.h>

#include "scree_capture_box2d.h"
#else
#include "scree_capture.h"
#endif

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

#ifdef COST_OF_BOX2D
using World = b2World;
using Body = b2Body;
using BodyDef = b2BodyDef;
using Circle = b2CircleShape;
using Polygon = b2PolygonShape;
using Edge = b2EdgeShape;
using Vec2 = b2Vec2;
using Contact = b2Contact;
constexpr auto moving = b2_dynamicBody;
#else
using World = scree::World;
using Body = scree::Body;
using BodyDef = scree::BodyDef;
using Circle = scree::CircleShape;
using Polygon = scree::PolygonShape;
using Edge = scree::EdgeShape;
using Vec2 = scree::Vec2;
using Contact = scree::Contact;
constexpr auto moving = scree::dynamicBody;
#endif

constexpr float timeStep = 1.0f / 60.0f;

void Advance(World& world) { world.Step(timeStep, 8, 3); }

void Fill(World& world) {
    const BodyDef still;
    Body* ground = world.CreateBody(&still);
    Edge edge;
    for (const float x : {-15.0f, 15.0f}) {
        edge.SetTwoSided(Vec2(x, 0.0f), Vec2(x, 200.0f));
        ground->CreateFixture(&edge, 0.0f);
    }
    edge.SetTwoSided(Vec2(-15.0f, 0.0f), Vec2(15.0f, 0.0f));
    ground->CreateFixture(&edge, 0.0f);
    for (int i = 0; i < 1000; ++i) {
        BodyDef def;
        def.type = moving;
        def.position.Set(-14.0f + static_cast<float>(i % 28) + 0.01f * static_cast<float>(i % 7),
                         1.0f + 1.05f * static_cast<float>(i / 28));
        Body* body = world.CreateBody(&def);
        Circle circle;
        circle.m_radius = 0.45f;
        Polygon box;
        box.SetAsBox(0.45f, 0.45f);
        i % 2 == 0 ? body->CreateFixture(&circle, 1.0f) : body->CreateFixture(&box, 1.0f);
    }
}

double Now() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

double MedianOf(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// True if the whole track is in its file.
bool Measure(const char* name, bool withContacts, bool withTree, int steps) {
    World world(Vec2(0.0f, -10.0f));
    world.SetAllowSleeping(false);
    Fill(world);
    constexpr int settling = 200;
    for (int i = 0; i < settling; ++i) Advance(world);
    scree_capture::Options options;
    options.contacts = withContacts;
    options.tree = withTree;
    scree_capture::Track track(world, "capture_cost.track", options);
    std::vector<double> stepping, recording;
    int touching = 0;
    for (int i = 0; i < steps; ++i) {
        int number = 0;
        for (Body* b = world.GetBodyList(); b != nullptr; b = b->GetNext()) {
            if (++number % 50 == i % 50) b->ApplyLinearImpulseToCenter(Vec2(0.2f, 0.5f), true);
        }
        const double begin = Now();
        Advance(world);
        const double stepped = Now();
        track.Step(timeStep);
        stepping.push_back(stepped - begin), recording.push_back(Now() - stepped);
    }
    for (Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) touching += c->IsTouching() ? 1 : 0;
    track.Close();
    const double step = MedianOf(stepping), record = MedianOf(recording);
    std::printf("%s: step %.0f us, recording %.1f us, %.1f %%; %d contacts touch\n", name, step, record,
                100.0 * record / step, touching);
    std::remove("capture_cost.track");
    return track.GetError().empty() && track.GetSkippedSteps() == 0;
}

}  // namespace

int main(int count, char** words) {
    const int steps = std::max(1, count > 1 ? std::atoi(words[1]) : 600);
    const bool isGood = Measure("without contacts", false, false, steps) &&
                        Measure("with contacts", true, false, steps) && Measure("with the tree", false, true, steps);
    return isGood ? 0 : 1;
}
