// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What must stand, hold and rest under the soft step, and never worse with more sub-steps. That is piles built flush,
// loads on chains, taut bridges, changing time steps, rings and nets, and figures that fall. Sizes and loads vary at
// random.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

constexpr int marks[] = {4, 8, 16};

struct Dice {
    std::mt19937 engine;
    explicit Dice(unsigned seed) : engine(seed) {}
    double In(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
};

/// Steps a laboratory of this library with so many sub-steps.
void StepSoft(Lab<Ours>& lab, int substeps, double dt = h) { lab.world.Step(static_cast<float>(dt), substeps); }

Body* AddBlock(Lab<Ours>& lab, double x, double y, double width, double height, double density = 1.0) {
    Body* body = lab.Dynamic(x, y);
    AttachBox<Ours>(body, 0.5 * width, 0.5 * height, {density, 0.6});
    return body;
}

/// How far the top of a flush column leans at most in ten seconds, m.
double Lean(int count, double width, double height, int substeps) {
    Lab<Ours> lab;
    lab.Ground(0.6);
    Body* top = nullptr;
    for (int i = 0; i < count; ++i) top = AddBlock(lab, 0.0, height * (i + 0.5), width, height);
    double lean = 0.0;
    for (int i = 0; i < 10 * stepRate; ++i) {
        StepSoft(lab, substeps);
        lean = std::max(lean, std::abs(Centre(top).x));
    }
    return Centre(top).y > 0.8 * count * height ? lean : 1e3;
}

TEST(Standing, FlushColumnsStandAtEveryMark) {
    Dice dice(1);
    for (const int count : {20, 40}) {
        const double width = dice.In(0.8, 1.1), height = dice.In(0.6, 0.8);
        for (const int substeps : marks)
            EXPECT_LT(Lean(count, width, height, substeps), 0.5 * width) << count << " " << substeps;
    }
}

/// Neither side of a contact is solved before the other.
TEST(Standing, ASymmetricColumnStaysUpright) {
    Dice dice(14);
    for (const int count : {10, 80, 120}) {
        const double width = dice.In(0.7, 1.1), height = dice.In(0.6, 0.8);
        for (const int substeps : marks)
            EXPECT_LT(Lean(count, width, height, substeps), 1e-4) << count << " " << substeps;
    }
}

struct Column {
    int count;
    double width, height, gap;  ///< of a box, and between two at the start, m
    double topDensity;          ///< of the others 1
};

/// Whether a column still stands after some seconds.
bool Stands(const Column& column, int substeps) {
    Lab<Ours> lab;
    lab.Ground(0.6);
    Body* top = nullptr;
    for (int i = 0; i < column.count; ++i) {
        const double y = column.height * (i + 0.5) + column.gap * i;
        top = AddBlock(lab, 0.0, y, column.width, column.height, i + 1 == column.count ? column.topDensity : 1.0);
    }
    for (int i = 0; i < 10 * stepRate; ++i) StepSoft(lab, substeps);
    return Centre(top).y > 0.8 * column.height * (column.count - 1);
}

TEST(Standing, ColumnsThatCloseTheirGapsStand) {
    Dice dice(11);
    for (int i = 0; i < 6; ++i) {
        const Column column{.count = static_cast<int>(dice.In(8.0, 28.0)),
                            .width = dice.In(0.7, 1.1),
                            .height = dice.In(0.6, 0.9),
                            .gap = dice.In(0.005, 0.12),
                            .topDensity = 1.0};
        for (const int substeps : marks)
            EXPECT_TRUE(Stands(column, substeps)) << column.count << " " << column.gap << " " << substeps;
    }
}

TEST(Standing, ColumnsBearAHeavyTop) {
    Dice dice(12);
    for (int i = 0; i < 6; ++i) {
        const Column column{.count = static_cast<int>(dice.In(6.0, 14.0)),
                            .width = dice.In(0.7, 1.1),
                            .height = dice.In(0.6, 0.9),
                            .gap = 0.0,
                            .topDensity = std::pow(10.0, dice.In(1.0, 2.0))};
        for (const int substeps : marks)
            EXPECT_TRUE(Stands(column, substeps)) << column.count << " " << column.topDensity << " " << substeps;
    }
}

TEST(Standing, FlushPyramidsFallAsleepWhereTheyWereBuilt) {
    Dice dice(2);
    for (const int substeps : marks) {
        Lab<Ours> lab;
        lab.world.SetAllowSleeping(true);
        lab.Ground(0.6);
        const double width = dice.In(0.9, 1.1), height = dice.In(0.7, 0.9), pitch = width * dice.In(1.05, 1.12);
        std::vector<std::pair<Body*, double>> bricks;
        for (int r = 0; r < 15; ++r) {
            for (int i = 0; i < 15 - r; ++i) {
                const double x = pitch * (i - 0.5 * (14 - r));
                bricks.emplace_back(AddBlock(lab, x, height * (r + 0.5), width, height), x);
            }
        }
        for (int i = 0; i < 3 * stepRate; ++i) StepSoft(lab, substeps);
        double shift = 0.0;
        for (const auto& [brick, x] : bricks) {
            EXPECT_FALSE(brick->IsAwake()) << substeps;
            shift = std::max(shift, std::abs(Centre(brick).x - x));
        }
        EXPECT_LT(shift, 0.02) << substeps;
    }
}

TEST(Standing, SmallBoxesRestOnTheFloor) {
    Dice dice(3);
    Lab<Ours> lab;
    Body* ground = lab.Static(0.0, -1.0);
    AttachBox<Ours>(ground, 50.0, 1.0);
    std::vector<std::pair<Body*, double>> boxes;
    for (int i = 0; i < 10; ++i) {
        const double size = std::pow(10.0, dice.In(-3.0, -1.0));
        boxes.emplace_back(AddBlock(lab, i, 0.5 * size, size, size), size);
    }
    for (int i = 0; i < 2 * stepRate; ++i) StepSoft(lab, 4);
    for (const auto& [box, size] : boxes) EXPECT_NEAR(Centre(box).y, 0.5 * size, std::min(1e-3, 0.25 * size));
}

struct Rope {
    double gap = 0.0, gain = 0.0;
};

/// A chain with a load, let go in a direction; gain of energy in weights of the load times the length.
Rope Swing(int links, double load, double angle, int substeps, unsigned seedOfSteps = 0) {
    Dice dice(seedOfSteps);
    Lab<Ours> lab;
    lab.world.SetContinuousPhysics(false);
    const double length = 0.5, width = 0.12;
    std::vector<Body*> bodies{lab.Static()};
    std::vector<Pin<Ours>> pins;
    const Point along{std::cos(angle), std::sin(angle)};
    const auto hold = [&](Body* body, int i) {
        pins.push_back(lab.Hinge(bodies.back(), body, along.x * length * i, along.y * length * i));
        bodies.push_back(body);
    };
    FixtureDef def;
    def.filter.groupIndex = -1;
    def.density = 1.0f;
    for (int i = 0; i < links; ++i) {
        Body* link = lab.Dynamic(along.x * length * (i + 0.5), along.y * length * (i + 0.5), angle);
        const auto box = BoxShape<Ours>(static_cast<float>(0.5 * length), static_cast<float>(0.5 * width));
        def.shape = &box;
        link->CreateFixture(&def);
        hold(link, i);
    }
    Body* weight = lab.Dynamic(along.x * length * links, along.y * length * links);
    const auto disk = CircleOf<Ours>(0.5f);
    def.shape = &disk;
    def.density = static_cast<float>(load * length * width / (circleRatio * 0.25));
    weight->CreateFixture(&def);
    hold(weight, links);
    const auto energy = [&] {
        double sum = 0.0;
        for (size_t i = 1; i < bodies.size(); ++i) {
            const Body* b = bodies[i];
            const double w = Spin(b);
            sum += double{b->GetMass()} * (0.5 * Dot(Speed(b), Speed(b)) + g * Centre(b).y);
            sum += 0.5 * double{b->GetInertia()} * w * w;
        }
        return sum;
    };
    const double start = energy(), unit = double{weight->GetMass()} * g * length * links;
    Rope rope;
    for (int i = 0; i < 4 * stepRate; ++i) {
        StepSoft(lab, substeps, seedOfSteps == 0 ? h : 1.0 / dice.In(20.0, 240.0));
        for (const Pin<Ours>& pin : pins) rope.gap = std::max(rope.gap, pin.Gap());
        rope.gain = std::max(rope.gain, (energy() - start) / unit);
    }
    return rope;
}

TEST(Standing, LoadedChainsHoldAtEveryMarkWithoutEnergy) {
    Dice dice(4);
    for (const double load : {100.0, 1000.0, 10000.0}) {
        const double angle = dice.In(-1.2, 0.2);
        for (const int substeps : marks) {
            const Rope rope = Swing(12, load * dice.In(0.7, 1.3), angle, substeps);
            EXPECT_LT(rope.gap, 1e-3) << load << " " << substeps;
            EXPECT_LT(rope.gain, 1e-3) << load << " " << substeps;
        }
    }
}

TEST(Standing, ChainsHoldUnderChangingTimeSteps) {
    for (const int substeps : marks) {
        const Rope rope = Swing(18, 160.0, -0.8, substeps, 11);
        EXPECT_LT(rope.gap, 1e-3) << substeps;
    }
}

TEST(Standing, ATautBridgeBearsALoad) {
    Dice dice(5);
    for (const int substeps : marks) {
        Lab<Ours> lab;
        Body* ground = lab.Static();
        std::vector<Pin<Ours>> pins;
        Body* last = ground;
        const int planks = 30;
        for (int i = 0; i < planks; ++i) {
            Body* plank = AddBlock(lab, 0.5 * (i + 0.5), 0.0, 0.5, 0.125);
            pins.push_back(lab.Hinge(last, plank, 0.5 * i, 0.0));
            last = plank;
        }
        pins.push_back(lab.Hinge(last, ground, 0.5 * planks, 0.0));
        AddBlock(lab, 0.25 * planks, 1.0, 1.5, 1.0, dice.In(0.5, 1.5));
        double gap = 0.0;
        for (int i = 0; i < 3 * stepRate; ++i) {
            StepSoft(lab, substeps);
            for (const Pin<Ours>& pin : pins) gap = std::max(gap, pin.Gap());
        }
        EXPECT_LT(gap, 1e-3) << substeps;
    }
}

TEST(Standing, ASpunRingKeepsItsAngularMomentum) {
    Dice dice(6);
    for (const int substeps : marks) {
        Lab<Ours> lab(0.0);
        const int count = 10;
        const double spin = dice.In(4.0, 9.0), radius = 1.5, inner = radius * std::cos(circleRatio / count);
        std::vector<Body*> bodies;
        for (int i = 0; i < count; ++i) {
            const double at = 2.0 * circleRatio * (i + 0.5) / count;
            const Point c{inner * std::cos(at), inner * std::sin(at)};
            Body* body = lab.Dynamic(c.x, c.y, at + 0.5 * circleRatio);
            const auto bar = BoxShape<Ours>(static_cast<float>(radius * std::sin(circleRatio / count)), 0.08f);
            FixtureDef def;
            def.shape = &bar;
            def.density = 1.0f;
            def.filter.groupIndex = -1;
            body->CreateFixture(&def);
            body->SetLinearVelocity(Lab<Ours>::At(-spin * c.y, spin * c.x));
            body->SetAngularVelocity(static_cast<float>(spin));
            bodies.push_back(body);
        }
        for (int i = 0; i < count; ++i) {
            const double at = 2.0 * circleRatio * (i + 1) / count;
            lab.Hinge(bodies[static_cast<size_t>(i)], bodies[static_cast<size_t>((i + 1) % count)],
                      radius * std::cos(at), radius * std::sin(at));
        }
        const double before = Sum(bodies).angular;
        for (int i = 0; i < 5 * stepRate; ++i) StepSoft(lab, substeps);
        EXPECT_NEAR(Sum(bodies).angular / before, 1.0, 0.02) << substeps;
    }
}

TEST(Standing, AFallingLimbDoesNotTearItsJoints) {
    Dice dice(7);
    for (const int substeps : marks) {
        Lab<Ours> lab;
        Body* ground = lab.Static(0.0, -1.0);
        AttachBox<Ours>(ground, 50.0, 1.0);
        std::vector<Pin<Ours>> pins;
        for (int figure = 0; figure < 6; ++figure) {
            const double x = 4.0 * figure, y = dice.In(5.0, 25.0), turn = dice.In(0.0, 6.28);
            const Point along{std::cos(turn), std::sin(turn)};
            Body* last = nullptr;
            for (int i = 0; i < 4; ++i) {
                Body* limb = lab.Dynamic(x + 0.4 * i * along.x, y + 0.4 * i * along.y, turn);
                const auto box = BoxShape<Ours>(0.19f, 0.06f);
                FixtureDef def;
                def.shape = &box;
                def.density = 1.0f;
                def.filter.groupIndex = -1;
                limb->CreateFixture(&def);
                if (last != nullptr)
                    pins.push_back(lab.Hinge(last, limb, x + 0.4 * (i - 0.5) * along.x, y + 0.4 * (i - 0.5) * along.y));
                last = limb;
            }
        }
        double gap = 0.0;
        for (int i = 0; i < 3 * stepRate; ++i) {
            StepSoft(lab, substeps);
            for (const Pin<Ours>& pin : pins) gap = std::max(gap, pin.Gap());
        }
        EXPECT_LT(gap, 0.05) << substeps;
    }
}

/// Limbs that begin with their middles at the ground and on their way into it: none is held there step after step.
TEST(Standing, FiguresInTheGroundAreNotHeldForEver) {
    Dice dice(16);
    for (int round = 0; round < 40; ++round) {
        Lab<Ours> lab;
        lab.Ground();
        Body* last = nullptr;
        for (int i = 0; i < 3; ++i) {
            Body* limb = lab.Dynamic(0.5 * i, dice.In(0.0, 0.02) + 0.1 * i);
            const auto box = BoxShape<Ours>(0.25f, 0.08f);
            FixtureDef def;
            def.shape = &box;
            def.density = 1.0f;
            def.filter.groupIndex = -1;
            limb->CreateFixture(&def);
            limb->SetLinearVelocity(Lab<Ours>::At(dice.In(-5.0, 5.0), dice.In(-10.0, -4.0)));
            limb->SetAngularVelocity(static_cast<float>(dice.In(-30.0, 30.0)));
            if (last != nullptr) lab.Hinge(last, limb, 0.5 * i - 0.25, Centre(last).y);
            last = limb;
        }
        int held = 0;
        for (int i = 0; i < 2 * stepRate; ++i) held += lab.world.Step(static_cast<float>(h), 4).abandonedCount;
        EXPECT_LE(held, 3 * 20) << round;
    }
}

/// How high the last ball of a cradle swings at first, in shares of how high the first ones were lifted (angles).
double Cradle(int count, int lifted, double radius, double gap, int substeps) {
    Lab<Ours> lab;
    Body* frame = lab.Static();
    const double length = 2.0, lift = 0.5;
    std::vector<Body*> balls;
    for (int i = 0; i < count; ++i) {
        const double x = (2.0 * radius + gap) * i, angle = i < lifted ? -lift : 0.0;
        Body* ball = lab.Dynamic(x + length * std::sin(angle), -length * std::cos(angle));
        AttachDisk<Ours>(ball, radius,
                         {.density = 1.0, .friction = 0.0, .restitution = 1.0, .restitutionThreshold = 0.0});
        DistanceJointDef def;
        def.Initialize(frame, ball, Lab<Ours>::At(x, 0.0), ball->GetPosition());
        def.minLength = def.maxLength = def.length;
        lab.world.CreateJoint(&def);
        balls.push_back(ball);
    }
    double most = 0.0;
    for (int i = 0; i < 2 * stepRate; ++i) {
        StepSoft(lab, substeps);
        const Point c = Centre(balls.back());
        most = std::max(most, std::atan2(c.x - (2.0 * radius + gap) * (count - 1), -c.y));
    }
    return most / lift;
}

TEST(Standing, ACradleHandsItsBlowOn) {
    Dice dice(13);
    for (const int lifted : {1, 2}) {
        const int count = static_cast<int>(dice.In(3.0, 7.0)) + lifted;
        const double radius = dice.In(0.15, 0.4), gap = dice.In(0.0, 0.02);
        for (const int substeps : marks)
            EXPECT_GT(Cradle(count, lifted, radius, gap, substeps), 0.9) << count << " " << gap << " " << substeps;
    }
}

}  // namespace
}  // namespace scree::test
