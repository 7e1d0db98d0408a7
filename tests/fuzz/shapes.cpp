// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Hulls and convex shapes of any points. Laws: what passes the checks has a finite mass and a finite box; casts against
// it stay on the ray; a body of it can be stepped and saved.

#include <cmath>
#include <memory>
#include <tuple>

#include "scree/scree.h"
#include "tests/fuzz/input.h"

namespace fuzz {
namespace {

using namespace scree;

void CheckAccepted(const Fixture& fixture, Input& input) {
    const Shape& shape = *fixture.GetShape();
    MassData mass{};
    shape.ComputeMass(&mass, 1.0f);
    Demand(std::isfinite(mass.mass) && mass.center.IsValid() && std::isfinite(mass.I), "a shape has a finite mass");
    AABB box{};
    shape.ComputeAABB(&box, Transform({1.0f, 2.0f}, Rot(0.7f)));
    Demand(box.IsValid(), "a shape has a finite box");
    RayCastOutput out{};
    RayCastInput ray{input.Point(), input.Point(), 1.0f};
    if (!ray.p1.IsValid() || !ray.p2.IsValid()) return;
    if (shape.RayCast(&out, ray, Transform({0.0f, 0.0f}, Rot(0.0f)))) {
        Demand(out.fraction >= 0.0f && out.fraction <= 1.0f, "a hit is on the ray");
    }
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace scree;
    fuzz::Input input(data, size);
    World world(Vec2{0.0f, -10.0f});
    world.SetErrorHandler([](const Error&, void*) {}, nullptr);
    for (int i = 0; i < 4 && !input.IsEmpty(); ++i) {
        BodyDef bodyDef;
        bodyDef.type = dynamicBody;
        bodyDef.position = {0.4f * static_cast<float>(i), 0.0f};
        Body* body = world.CreateBody(&bodyDef);
        Vec2 points[64];
        const int count = 1 + input.Choose(64);
        for (int k = 0; k < count; ++k) points[k] = input.Point();
        PolygonShape polygon;
        const Fixture* made = nullptr;
        switch (input.Choose(6)) {
            case 0:
                if (!polygon.Set(points, count)) break;
                made = body->CreateFixture(&polygon, 1.0f);
                break;
            case 1: {
                const ConvexShape shape = MakePolygon(points, count);
                made = body->CreateFixture(&shape, 1.0f);
                break;
            }
            case 2: {
                const ConvexShape shape = MakeRoundedPolygon(points, count, input.Amount());
                made = body->CreateFixture(&shape, 1.0f);
                break;
            }
            case 3: {
                const auto [width, height, angle] = std::tuple{input.Amount(), input.Amount(), input.Number()};
                const ConvexShape shape = MakeEllipse(width, height, points[0], angle);
                made = body->CreateFixture(&shape, 1.0f);
                break;
            }
            case 4: {
                const auto [radius, half, angle] = std::tuple{input.Amount(), input.Amount(), input.Number()};
                const ConvexShape shape = MakeCircleSector(radius, half, points[0], angle);
                made = body->CreateFixture(&shape, 1.0f);
                break;
            }
            default: {
                const ConvexShape shape = MakeCapsule(points[0], points[1], input.Amount());
                made = body->CreateFixture(&shape, 1.0f);
            }
        }
        if (made != nullptr) fuzz::CheckAccepted(*made, input);
    }
    world.Step(1.0f / 60.0f, 4);
    world.Step(1.0f / 60.0f, 8, 3);
    fuzz::Demand(LoadWorld(SaveWorld(world)) != nullptr, "what was saved can be loaded");
    return 0;
}
