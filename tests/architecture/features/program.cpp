// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program whose world models what the scene `box-stack` requires, and nothing else: the header is written by `scree
// requires`. Its state hash after every step is that of a world with everything on. With USE_… defined it uses what the
// set does not have: then it must not compile.

#include <scree/inspect.h>
#include <scree/scree.h>

#include <cinttypes>
#include <cstdio>

#include "box_stack_features.h"

namespace {

using FixedWorld = scree::FixedWorld<box_stack_features>;

/// A stack of boxes on the ground; `CreateBody` and `AddBox` are those of either kind of world.
template <typename CreateBody, typename AddBox>
void BuildStack(CreateBody&& create, AddBox&& addBox) {
    scree::BodyDef def = FixedWorld::MakeBodyDef();
    addBox(create(def), 20.0f, 0.5f);
    def.type = scree::dynamicBody;
    for (int i = 0; i < 10; ++i) {
        def.position = {0.02f * static_cast<float>(i % 3), 1.0f + 1.01f * static_cast<float>(i)};
        addBox(create(def), 0.5f, 0.5f);
    }
}

scree::FixtureDef MakeFixture() {
    scree::FixtureDef def = FixedWorld::MakeFixtureDef();
    def.density = 1.0f;
    return def;
}

}  // namespace

int main() {
    FixedWorld fixed;
    scree::WorldDef fullDef = FixedWorld::MakeWorldDef();
    fullDef.featureMode = scree::FeatureMode::full;
    scree::World full(fullDef);
    BuildStack([&](const scree::BodyDef& def) { return fixed.CreateBody(def); },
               [&](FixedWorld::BodyHandle body, float x, float y) {
                   scree::PolygonShape box;
                   box.SetAsBox(x, y);
                   body.CreateFixture(box, MakeFixture());
               });
    BuildStack([&](const scree::BodyDef& def) { return full.CreateBody(&def); },
               [&](scree::Body* body, float x, float y) {
                   scree::PolygonShape box;
                   box.SetAsBox(x, y);
                   scree::FixtureDef def = MakeFixture();
                   def.shape = &box;
                   body->CreateFixture(&def);
               });

#if defined(USE_DAMPING)
    fixed.CreateBody(FixedWorld::MakeBodyDef()).SetLinearDamping(0.5f);
#elif defined(USE_FORCES)
    fixed.CreateBody(FixedWorld::MakeBodyDef()).ApplyForceToCenter({1.0f, 0.0f}, true);
#elif defined(USE_JOINTS)
    fixed.CreateJoint(scree::RevoluteJointDef());
#elif defined(USE_EVENTS)
    scree::ContactListener listener;
    fixed.SetContactListener(&listener);
#endif

    for (int step = 0; step < 120; ++step) {
        fixed.Step(1.0f / 60.0f, 8, 3);
        full.Step(1.0f / 60.0f, 8, 3);
        const uint64_t a = scree::inspect::GetStateHash(fixed.Get()), b = scree::inspect::GetStateHash(full);
        if (a == b) continue;
        std::printf("step %d: 0x%016" PRIx64 " with the set, 0x%016" PRIx64 " with everything\n", step, a, b);
        return 1;
    }
    if (scree::inspect::GetKernels(fixed.Get()) == scree::inspect::GetKernels(full)) return 2;
    std::printf("the same 120 hashes with kernels %s\n", GetName(scree::inspect::GetKernels(fixed.Get())).c_str());

    // What only a value asks for is an error code.
    scree::BodyDef damped = FixedWorld::MakeBodyDef();
    damped.type = scree::dynamicBody;
    damped.linearDamping = 1.0f;
    scree::ErrorCode code = scree::ErrorCode::ok;
    fixed.Get().SetErrorHandler([](const scree::Error& e, void* to) { *static_cast<scree::ErrorCode*>(to) = e.code; },
                                &code);
    return !fixed.CreateBody(damped) && code == scree::ErrorCode::missingFeature ? 0 : 3;
}
