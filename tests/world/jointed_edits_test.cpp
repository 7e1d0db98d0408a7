// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the solvers keep of joints from step to step follows every edit. A world that was edited goes on as one that was
// loaded from its image, which keeps nothing.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "scree/snapshot.h"
#include "tests/world/random_hinges.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

/// Figures of hinged limbs and cars on wheels, some in loops, that fall on the ground and fall asleep one by one.
class Crowd {
public:
    explicit Crowd(uint32_t seed) : world(Vec2{0.0f, -10.0f}), m_draw(seed) {
        AddBox(AddBody(world, staticBody, {0.0f, -1.0f}), 400.0f, 1.0f);
        for (int i = 0; i < 50; ++i) AddFigure({4.0f * static_cast<float>(i) - 100.0f, m_draw.Any(0.6f, 2.0f)});
        for (int i = 0; i < 25; ++i) AddCar({8.0f * static_cast<float>(i) - 100.0f, m_draw.Any(6.0f, 7.0f)});
    }

    /// One change of a random kind.
    void Edit() {
        const auto any = [&](const auto& list) { return list[m_draw.Below(static_cast<uint32_t>(list.size()))]; };
        Body* body = any(m_bodies);
        Joint* joint = any(m_joints);
        switch (m_draw.Below(9)) {
            case 0:  // mostly of one that joints meet in, and later back
                if (m_frozen == nullptr) {
                    m_frozen = body->GetJointCount() > 1 ? body : joint->GetBodyA();
                    m_frozen->SetType(staticBody);
                } else {
                    m_frozen->SetType(dynamicBody);
                    m_frozen = nullptr;
                }
                break;
            case 1:
                body->SetFixedRotation(!body->IsFixedRotation());
                break;
            case 2: {
                MassData mass;
                body->GetMassData(&mass);
                mass.mass *= m_draw.Any(0.5f, 2.0f);
                mass.I *= 2.0f;
                body->SetMassData(&mass);
                break;
            }
            case 3:  // lanes do not turn so far
                body->SetTransform(body->GetPosition(), m_draw.OneIn(2) ? 0.0f : 1.0e9f);
                break;
            case 4:
                if (auto* hinge = dynamic_cast<RevoluteJoint*>(joint)) hinge->EnableLimit(!hinge->IsLimitEnabled());
                if (auto* wheel = dynamic_cast<WheelJoint*>(joint)) wheel->EnableMotor(!wheel->IsMotorEnabled());
                break;
            case 5:
                Replace(m_draw.OneIn(2) ? m_joints.back() : joint);  // the newest stays where it is in lists
                break;
            case 6:
                body->SetEnabled(!body->IsEnabled());
                break;
            case 7:
                body->SetAwake(!body->IsAwake());
                break;
            default:
                Hinge(body, any(m_bodies));
        }
    }

    World world;

private:
    void Hinge(Body* a, Body* b) {
        if (a == b) return;
        RevoluteJointDef def;
        def.Initialize(a, b, 0.5f * (a->GetWorldCenter() + b->GetWorldCenter()));
        if (!m_draw.OneIn(3)) GiveRange(def, m_draw);
        m_joints.push_back(world.CreateJoint(&def));
    }
    void AddFigure(Vec2 place) {
        std::vector<Body*> limbs;
        const int count = 2 + static_cast<int>(m_draw.Below(5));
        for (int i = 0; i < count; ++i) {
            limbs.push_back(AddLimb(world, place + Vec2{0.5f * static_cast<float>(i), 0.0f}, 2.0f, m_draw));
            if (i > 0) Hinge(limbs[m_draw.Below(static_cast<uint32_t>(i))], limbs.back());
        }
        m_bodies.insert(m_bodies.end(), limbs.begin(), limbs.end());
    }
    void AddCar(Vec2 place) {
        Body* chassis = AddLimb(world, place, 2.0f, m_draw);
        m_bodies.push_back(chassis);
        for (const float side : {-0.6f, 0.6f}) {
            Body* wheel = AddBody(world, dynamicBody, place + Vec2{side, -0.4f});
            AddCircle(wheel, 0.25f);
            WheelJointDef def;
            def.Initialize(chassis, wheel, wheel->GetPosition(), {0.0f, 1.0f});
            LinearStiffness(def.stiffness, def.damping, 5.0f, 0.7f, chassis, wheel);
            def.enableMotor = m_draw.OneIn(2);
            def.motorSpeed = m_draw.Any(-5.0f, 5.0f);
            def.maxMotorTorque = 5.0f;
            def.enableLimit = m_draw.OneIn(2);
            def.lowerTranslation = -0.1f;
            def.upperTranslation = 0.1f;
            m_joints.push_back(world.CreateJoint(&def));
            m_bodies.push_back(wheel);
        }
    }
    /// By one of another type or with another body, which gets its number.
    void Replace(Joint* joint) {
        std::erase(m_joints, joint);
        Body *a = joint->GetBodyA(), *b = joint->GetBodyB();
        world.DestroyJoint(joint);
        DistanceJointDef def;
        def.Initialize(a, b, a->GetWorldCenter(), b->GetWorldCenter());
        if (m_draw.OneIn(2)) {
            m_joints.push_back(world.CreateJoint(&def));
        } else {
            Hinge(a, m_draw.OneIn(2) ? b : m_bodies[m_draw.Below(static_cast<uint32_t>(m_bodies.size()))]);
        }
    }

    Draws m_draw;
    std::vector<Body*> m_bodies;
    std::vector<Joint*> m_joints;
    Body* m_frozen = nullptr;
};

TEST(JointedEdits, AnEditedWorldGoesOnAsItsImageDoes) {
    for (uint32_t seed = 1; seed <= 3; ++seed) {
        for (const int substeps : solvers) {
            for (const int workers : {1, 4}) {
                Crowd crowd(seed);
                crowd.world.SetWorkers(workers);
                if (workers > 1) crowd.world.GetState().pool->ShareAlways();
                for (int step = 0; step < 120; ++step) {
                    if (step % 3 == 2) crowd.Edit();
                    const std::unique_ptr<World> fresh = LoadWorld(SaveWorld(crowd.world));
                    ASSERT_NE(fresh, nullptr);
                    StepWith(crowd.world, substeps);
                    StepWith(*fresh, substeps);
                    ASSERT_EQ(inspect::GetStateHash(crowd.world), inspect::GetStateHash(*fresh))
                        << seed << ' ' << substeps << ' ' << workers << ' ' << step;
                }
            }
        }
    }
}

}  // namespace
}  // namespace scree::test
