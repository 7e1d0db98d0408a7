// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs one program by name, or lists the names.

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "program.h"

// Its own layout of this list changes with every run.
// clang-format off
#define SCREE_PROGRAMS(X) \
    X(HelloWorld) X(BodyTypes) X(UserData) X(Masses) X(Filters) X(Sleeping) X(Forces) X(Lists) X(FixtureEdits) \
    X(EnabledBodies) X(StepZero) X(ListenerSequence) X(Sensors) X(OneWayPlatform) X(ConveyorBelt) \
    X(WorldManifolds) X(Breakable) X(DestructionOrder) X(ChainTerrain) X(ChainLoop) X(ContactGraph) X(Bounces) \
    X(ThinWall) X(Revolute) X(Prismatic) X(Distance) X(Pulley) X(Gears) X(Mouse) X(Car) X(Weld) \
    X(FrictionAndMotor) X(Ragdoll) X(Bridge) X(RayCasts) X(BoxQueries) X(ShapeCasts) X(Distances) \
    X(TimesOfImpact) X(Manifolds) X(DynamicTree) X(BroadPhase) X(Allocators) X(Math) X(Drawing) X(Pyramid) \
    X(Dominoes) X(Character) X(OriginShift) X(Overlaps) X(CallbackEdits) X(QueryEdits) X(BeginOrder) \
    X(EditedBodies) X(Counters) X(Platformer) X(BreakableCrates) X(TopDownCar) X(Buoyancy) X(SensorDoor) X(JointBreak) X(LevelTool) X(TerrainDrive)
// clang-format on

#define SCREE_DECLARE(name) void name();
SCREE_PROGRAMS(SCREE_DECLARE)

namespace {

#define SCREE_ENTRY(name) {#name, name},
const Program programs[] = {SCREE_PROGRAMS(SCREE_ENTRY)};

}  // namespace

void Say(const char* format, ...) {
    std::printf("= ");
    va_list args;
    va_start(args, format);
    std::vprintf(format, args);
    va_end(args);
    std::printf("\n");
}

void Number(const std::string& name, double value, double tolerance) {
    std::printf("~ %s %.9g %.3g\n", name.c_str(), value, tolerance);
}

void Number(const std::string& name, const b2Vec2& value, double tolerance) {
    Number(name + ".x", value.x, tolerance);
    Number(name + ".y", value.y, tolerance);
}

void Pose(const std::string& name, const b2Body* body, double tolerance) {
    Number(name, body->GetPosition(), tolerance);
    Number(name + ".angle", body->GetAngle(), tolerance);
}

b2Body* MakeGround(b2World& world, float y) {
    b2BodyDef def;
    b2Body* ground = world.CreateBody(&def);
    b2EdgeShape edge;
    edge.SetTwoSided(b2Vec2(-100.0f, y), b2Vec2(100.0f, y));
    ground->CreateFixture(&edge, 0.0f);
    return ground;
}

namespace {

b2Body* MakeDynamic(b2World& world, float x, float y, const b2Shape& shape, float density) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(x, y);
    b2Body* body = world.CreateBody(&def);
    body->CreateFixture(&shape, density);
    return body;
}

}  // namespace

b2Body* MakeBox(b2World& world, float x, float y, float hx, float hy, float density) {
    b2PolygonShape box;
    box.SetAsBox(hx, hy);
    return MakeDynamic(world, x, y, box, density);
}

b2Body* MakeDisk(b2World& world, float x, float y, float radius, float density) {
    b2CircleShape disk;
    disk.m_radius = radius;
    return MakeDynamic(world, x, y, disk, density);
}

void Run(b2World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.Step(1.0f / 60.0f, 8, 3);
}

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    for (const Program& program : programs) {
        if (std::strcmp(argv[1], "--list") == 0) {
            std::printf("%s\n", program.name);
        } else if (std::strcmp(argv[1], program.name) == 0) {
            program.run();
            return 0;
        }
    }
    return std::strcmp(argv[1], "--list") == 0 ? 0 : 3;
}
