// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs about geometry: rays, boxes, casts, distance, manifolds, trees, allocators, math, drawing.

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include "program.h"

namespace {

class ClosestHit : public b2RayCastCallback {
public:
    float ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal, float fraction) override {
        if (fixture->GetUserData().pointer == 99) return -1.0f;
        hit = fixture;
        m_point = point;
        m_normal = normal;
        m_fraction = fraction;
        return fraction;
    }
    b2Fixture* hit = nullptr;
    b2Vec2 m_point, m_normal;
    float m_fraction = 0.0f;
};

class AllHits : public b2RayCastCallback {
public:
    float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float) override {
        found.insert(fixture->GetUserData().pointer);
        return 1.0f;
    }
    std::multiset<uintptr_t> found;
};

class FirstHit : public b2RayCastCallback {
public:
    float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float) override {
        ++count;
        return 0.0f;
    }
    int count = 0;
};

class Collector : public b2QueryCallback {
public:
    explicit Collector(int limit) : m_limit(limit) {}
    bool ReportFixture(b2Fixture* fixture) override {
        found.insert(fixture->GetUserData().pointer);
        return ++count < m_limit;
    }
    std::set<uintptr_t> found;
    int count = 0;

private:
    int m_limit;
};

template <typename Set>
std::string Text(const Set& found) {
    std::string text;
    for (const auto id : found) text += std::to_string(id) + " ";
    return text;
}

void FillRow(b2World& world) {
    b2BodyDef def;
    b2PolygonShape box;
    b2CircleShape circle;
    b2EdgeShape edge;
    for (int i = 0; i < 12; ++i) {
        def.position.Set(3.0f * static_cast<float>(i), 0.2f * static_cast<float>(i % 3));
        def.angle = 0.1f * static_cast<float>(i);
        b2Body* body = world.CreateBody(&def);
        box.SetAsBox(0.5f, 0.8f);
        circle.m_radius = 0.7f;
        edge.SetTwoSided(b2Vec2(-0.2f, -1.0f), b2Vec2(0.2f, 1.0f));
        const b2Shape* shapes[] = {&box, &circle, &edge};
        body->CreateFixture(shapes[i % 3], 0.0f)->GetUserData().pointer = static_cast<uintptr_t>(i + 1);
    }
}

}  // namespace

void RayCasts() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillRow(world);
    for (int i = 0; i < 6; ++i) {
        const float slope = 0.05f * static_cast<float>(i);
        ClosestHit closest;
        world.RayCast(&closest, b2Vec2(-5.0f + 8.0f * static_cast<float>(i), 0.1f), b2Vec2(40.0f, 0.1f + slope));
        if (closest.hit == nullptr) continue;
        Say("closest %d", static_cast<int>(closest.hit->GetUserData().pointer));
        Number("point", closest.m_point, 1e-4);
        Number("normal", closest.m_normal, 1e-4);
        Number("fraction", closest.m_fraction, 1e-5);
    }
    AllHits all;
    world.RayCast(&all, b2Vec2(-5.0f, 0.1f), b2Vec2(40.0f, 0.3f));
    Say("all %s", Text(all.found).c_str());
    FirstHit first;
    world.RayCast(&first, b2Vec2(-5.0f, 0.1f), b2Vec2(40.0f, 0.3f));
    Say("any %d", first.count);
    b2Fixture* fixture = world.GetBodyList()->GetFixtureList();
    b2RayCastInput input;
    input.p1.Set(33.0f, 5.0f);
    input.p2.Set(33.1f, -5.0f);
    input.maxFraction = 1.0f;
    b2RayCastOutput output;
    const bool hit = fixture->RayCast(&output, input, 0);
    Say("direct %d", hit);
    if (hit) Number("normal", output.normal, 1e-4);
    // A chain is one fixture; rays meet it from both sides.
    b2ChainShape chain;
    const b2Vec2 line[] = {b2Vec2(5.0f, 10.0f), b2Vec2(0.0f, 10.0f), b2Vec2(-5.0f, 11.0f)};
    chain.CreateChain(line, 3, b2Vec2(6.0f, 10.0f), b2Vec2(-6.0f, 11.0f));
    b2BodyDef def;
    world.CreateBody(&def)->CreateFixture(&chain, 0.0f)->GetUserData().pointer = 50;
    for (const float y : {15.0f, 5.0f}) {
        ClosestHit closest;
        world.RayCast(&closest, b2Vec2(-2.0f, y), b2Vec2(-2.0f, 20.0f - y));
        Say("chain %d", closest.hit != nullptr ? static_cast<int>(closest.hit->GetUserData().pointer) : 0);
        if (closest.hit != nullptr) Number("chain normal", closest.m_normal, 1e-4);
    }
}

void BoxQueries() {
    b2World world(b2Vec2(0.0f, -10.0f));
    FillRow(world);
    b2AABB box;
    box.lowerBound.Set(5.0f, -0.5f);
    box.upperBound.Set(19.0f, 0.5f);
    Collector all(1000);
    world.QueryAABB(&all, box);
    Say("found %s", Text(all.found).c_str());
    Collector three(3);
    world.QueryAABB(&three, box);
    Say("stopped after %d", three.count);
    Say("valid %d contains %d", box.IsValid(), box.Contains(box));
    Number("perimeter", box.GetPerimeter());
    b2RayCastInput input;
    input.p1.Set(0.0f, 0.0f);
    input.p2.Set(10.0f, 0.5f);
    input.maxFraction = 1.0f;
    b2RayCastOutput output;
    Say("ray %d", box.RayCast(&output, input));
    Number("fraction", output.fraction, 1e-5);
    Number("normal", output.normal);
    b2AABB other;
    other.lowerBound.Set(19.0f, 0.5f);
    other.upperBound.Set(21.0f, 1.5f);
    Say("touching boxes %d", b2TestOverlap(box, other));
    box.Combine(other);
    Number("center", box.GetCenter());
    Number("extents", box.GetExtents());
}

void ShapeCasts() {
    const b2Vec2 triangle[] = {b2Vec2(-0.5f, 1.0f), b2Vec2(0.5f, 1.0f), b2Vec2(0.0f, 0.0f)};
    const b2Vec2 square[] = {b2Vec2(-0.5f, -0.5f), b2Vec2(0.5f, -0.5f), b2Vec2(0.5f, 0.5f), b2Vec2(-0.5f, 0.5f)};
    for (int i = 0; i < 6; ++i) {
        b2ShapeCastInput input;
        input.proxyA.Set(triangle, 3, b2_polygonRadius);
        input.proxyB.Set(square, 4, i % 2 == 0 ? b2_polygonRadius : 0.3f);
        input.transformA.Set(b2Vec2(0.0f, 0.25f), 0.2f * static_cast<float>(i));
        input.transformB.Set(b2Vec2(-4.0f, 0.3f * static_cast<float>(i) - 0.5f), 0.0f);
        input.translationB.Set(8.0f, 0.0f);
        b2ShapeCastOutput output;
        const bool hit = b2ShapeCast(&output, &input);
        Say("hit %d", hit);
        if (!hit) continue;
        Number("lambda", output.lambda, 2e-3);
        Number("normal", output.normal, 1e-2);
        Number("point", output.point, 2e-2);
    }
}

void Distances() {
    b2PolygonShape a;
    a.SetAsBox(10.0f, 0.2f);
    b2PolygonShape b;
    b.SetAsBox(2.0f, 0.1f);
    b2CircleShape c;
    c.m_radius = 0.5f;
    const b2Shape* seconds[] = {&b, &c};
    for (int i = 0; i < 8; ++i) {
        b2DistanceInput input;
        input.proxyA.Set(&a, 0);
        input.proxyB.Set(seconds[i % 2], 0);
        input.transformA.Set(b2Vec2(0.0f, -0.2f), 0.0f);
        input.transformB.Set(b2Vec2(12.0f + 0.4f * static_cast<float>(i % 4), 0.5f), 0.3f * static_cast<float>(i));
        input.useRadii = i < 4;
        b2SimplexCache cache;
        cache.count = 0;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        Number("distance", output.distance, 1e-4);
        Number("A", output.pointA, 1e-3);
        Number("B", output.pointB, 1e-3);
        Say("cached %d", cache.count > 0);
    }
    b2DistanceProxy proxy;
    proxy.Set(&b, 0);
    Say("support %d of %d", proxy.GetSupport(b2Vec2(1.0f, 1.0f)), proxy.GetVertexCount());
}

void TimesOfImpact() {
    b2PolygonShape a;
    a.SetAsBox(25.0f, 5.0f);
    b2PolygonShape b;
    b.SetAsBox(2.5f, 2.5f);
    for (int i = 0; i < 6; ++i) {
        b2TOIInput input;
        input.proxyA.Set(&a, 0);
        input.proxyB.Set(&b, 0);
        input.sweepA.localCenter.SetZero();
        input.sweepA.c0.Set(24.0f, -60.0f);
        input.sweepA.a0 = 2.95f;
        input.sweepA.c = input.sweepA.c0;
        input.sweepA.a = 2.95f;
        input.sweepA.alpha0 = 0.0f;
        input.sweepB.localCenter.SetZero();
        input.sweepB.c0.Set(53.474274f, -50.252514f + 3.0f * static_cast<float>(i));
        input.sweepB.a0 = 513.36676f;
        input.sweepB.c.Set(54.595478f, -51.083473f - 8.0f * static_cast<float>(i));
        input.sweepB.a = 513.62781f;
        input.sweepB.alpha0 = 0.0f;
        input.tMax = 1.0f;
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        Say("state %d", output.state);
        Number("t", output.t, 2e-3);
        b2Transform xf;
        input.sweepB.GetTransform(&xf, output.t);
        Number("p", xf.p, 0.1);
    }
}

void Manifolds() {
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2PolygonShape slab;
    slab.SetAsBox(2.0f, 0.3f, b2Vec2(0.1f, 0.0f), 0.05f);
    b2CircleShape disk;
    disk.m_radius = 0.4f;
    disk.m_p.Set(0.1f, 0.0f);
    b2EdgeShape edge;
    edge.SetTwoSided(b2Vec2(-1.0f, 0.0f), b2Vec2(1.0f, 0.1f));
    b2Transform xfA;
    xfA.SetIdentity();
    for (int i = 0; i < 12; ++i) {
        b2Transform xfB;
        xfB.Set(b2Vec2(-0.6f + 0.11f * static_cast<float>(i), 0.7f), 0.37f * static_cast<float>(i));
        b2Manifold m[5];
        b2CollidePolygons(&m[0], &slab, xfA, &box, xfB);
        b2CollidePolygonAndCircle(&m[1], &slab, xfA, &disk, xfB);
        b2CollideCircles(&m[2], &disk, xfA, &disk, xfB);
        b2CollideEdgeAndCircle(&m[3], &edge, xfA, &disk, xfB);
        b2CollideEdgeAndPolygon(&m[4], &edge, xfA, &box, xfB);
        for (const b2Manifold& manifold : m) {
            Say("points %d", manifold.pointCount);
            if (manifold.pointCount == 0) continue;
            Say("type %d", manifold.type);
            for (int k = 0; k < manifold.pointCount; ++k) {
                const b2ContactFeature& cf = manifold.points[k].id.cf;
                Number("local", manifold.points[k].localPoint, 1e-4);
                Say("id %d %d %d %d", cf.indexA, cf.indexB, cf.typeA, cf.typeB);
            }
            b2WorldManifold world;
            world.Initialize(&manifold, xfA, b2_polygonRadius, xfB, b2_polygonRadius);
            Number("normal", world.normal, 1e-4);
            Number("separation", world.separations[0], 1e-4);
        }
    }
}

namespace {

struct TreeUser {
    bool QueryCallback(int32 proxyId) {
        found.insert(*static_cast<int*>(tree.GetUserData(proxyId)));
        return true;
    }
    float RayCastCallback(const b2RayCastInput& input, int32 proxyId) {
        hits.insert(*static_cast<int*>(tree.GetUserData(proxyId)));
        return input.maxFraction;
    }
    b2DynamicTree tree;
    std::set<int> found, hits;
};

b2AABB BoxAt(float x, float y, float half) {
    b2AABB box;
    box.lowerBound.Set(x - half, y - half);
    box.upperBound.Set(x + half, y + half);
    return box;
}

}  // namespace

void DynamicTree() {
    TreeUser user;
    int numbers[64];
    int32 proxies[64];
    for (int i = 0; i < 64; ++i) {
        numbers[i] = i;
        proxies[i] =
            user.tree.CreateProxy(BoxAt(static_cast<float>(i % 8), static_cast<float>(i / 8), 0.3f), &numbers[i]);
    }
    user.tree.Query(&user, BoxAt(2.0f, 3.0f, 1.2f));
    Say("found %s", Text(user.found).c_str());
    b2RayCastInput input;
    input.p1.Set(-2.0f, 1.0f);
    input.p2.Set(10.0f, 5.0f);
    input.maxFraction = 1.0f;
    user.tree.RayCast(&user, input);
    Say("hits %s", Text(user.hits).c_str());
    Say("small move %d", user.tree.MoveProxy(proxies[9], BoxAt(1.05f, 1.0f, 0.3f), b2Vec2(0.05f, 0.0f)));
    Say("large move %d", user.tree.MoveProxy(proxies[9], BoxAt(20.0f, 20.0f, 0.3f), b2Vec2(1.0f, 0.0f)));
    Number("fat", user.tree.GetFatAABB(proxies[9]).upperBound, 1e-5);
    Say("moved %d", user.tree.WasMoved(proxies[9]));
    user.tree.ClearMoved(proxies[9]);
    Say("moved %d", user.tree.WasMoved(proxies[9]));
    user.tree.DestroyProxy(proxies[10]);
    user.tree.ShiftOrigin(b2Vec2(1.0f, 0.0f));
    user.found.clear();
    user.tree.Query(&user, BoxAt(1.0f, 1.0f, 1.2f));
    Say("found %s", Text(user.found).c_str());
    user.tree.Validate();
    Say("high %d balanced %d", user.tree.GetHeight() >= 6 && user.tree.GetHeight() <= 12,
        user.tree.GetMaxBalance() <= 4);
    user.tree.RebuildBottomUp();
    Say("ratio %d", user.tree.GetAreaRatio() > 1.0f);
}

namespace {

struct PairCollector {
    void AddPair(void* a, void* b) {
        const int i = *static_cast<int*>(a);
        const int j = *static_cast<int*>(b);
        pairs.insert({std::min(i, j), std::max(i, j)});
    }
    std::set<std::pair<int, int>> pairs;
};

}  // namespace

void BroadPhase() {
    b2BroadPhase broadPhase;
    int numbers[10];
    int32 proxies[10];
    for (int i = 0; i < 10; ++i) {
        numbers[i] = i;
        proxies[i] = broadPhase.CreateProxy(BoxAt(1.5f * static_cast<float>(i), 0.0f, 0.7f), &numbers[i]);
    }
    PairCollector first;
    broadPhase.UpdatePairs(&first);
    PairCollector second;
    broadPhase.UpdatePairs(&second);
    broadPhase.MoveProxy(proxies[0], BoxAt(6.0f, 0.0f, 0.7f), b2Vec2(6.0f, 0.0f));
    broadPhase.TouchProxy(proxies[9]);
    PairCollector third;
    broadPhase.UpdatePairs(&third);
    for (const auto& collector : {first, second, third}) {
        std::string text;
        for (const auto& [a, b] : collector.pairs) text += std::to_string(a) + "-" + std::to_string(b) + " ";
        Say("pairs %s", text.c_str());
    }
    Say("%d %d %d", broadPhase.GetProxyCount(), broadPhase.TestOverlap(proxies[0], proxies[4]),
        broadPhase.GetTreeHeight() > 2);
    broadPhase.DestroyProxy(proxies[3]);
    Say("%d", broadPhase.GetProxyCount());
}

void Allocators() {
    b2BlockAllocator blocks;
    std::set<void*> distinct;
    for (int i = 1; i < 900; i += 7) {
        void* p = blocks.Allocate(i);
        std::memset(p, i & 0xFF, static_cast<size_t>(i));
        distinct.insert(p);
        if (i % 2 == 0) blocks.Free(p, i);
        if (i % 2 == 0) distinct.erase(p);
        if (i > 640 && i % 2 != 0) blocks.Free(p, i);
    }
    Say("distinct %d", distinct.size() > 60);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 2.0f);
    b2Shape* clone = box.Clone(&blocks);
    b2MassData mass;
    clone->ComputeMass(&mass, 2.0f);
    Number("clone", mass.mass);
    b2StackAllocator stack;
    void* a = stack.Allocate(1000);
    void* b = stack.Allocate(200 * 1024);
    stack.Free(b);
    stack.Free(a);
    Say("most %d", stack.GetMaxAllocation());
    b2GrowableStack<int32, 4> growable;
    for (int i = 0; i < 100; ++i) growable.Push(i);
    Say("top %d of %d", growable.Pop(), growable.GetCount());
    b2Timer timer;
    Say("time %d", timer.GetMilliseconds() >= 0.0f);
}

void Math() {
    const b2Mat22 m(1.0f, 2.0f, 3.0f, 5.0f);
    Number("solve", m.Solve(b2Vec2(1.0f, 2.0f)));
    Number("inverse", b2Mul(m.GetInverse(), b2Vec2(1.0f, 2.0f)), 1e-4);
    Number("transposed", b2MulT(m, b2Vec2(1.0f, 2.0f)));
    const b2Mat33 n(b2Vec3(4.0f, 1.0f, 2.0f), b2Vec3(1.0f, 5.0f, 3.0f), b2Vec3(2.0f, 3.0f, 6.0f));
    const b2Vec3 x = n.Solve33(b2Vec3(1.0f, 2.0f, 3.0f));
    Number("x", x.x, 1e-5);
    Number("y", x.y, 1e-5);
    Number("z", x.z, 1e-5);
    Number("22", n.Solve22(b2Vec2(1.0f, 2.0f)), 1e-5);
    b2Mat33 inverse;
    n.GetSymInverse33(&inverse);
    Number("sym", b2Dot(b2Mul(inverse, b2Vec3(1.0f, 2.0f, 3.0f)), b2Vec3(1.0f, 1.0f, 1.0f)), 1e-5);
    n.GetInverse22(&inverse);
    Number("inv22", b2Mul22(inverse, b2Vec2(1.0f, 2.0f)), 1e-5);
    b2Transform a(b2Vec2(1.0f, 2.0f), b2Rot(0.5f));
    b2Transform b;
    b.Set(b2Vec2(-3.0f, 1.0f), -1.2f);
    Number("mul", b2Mul(b2Mul(a, b), b2Vec2(0.3f, 0.4f)), 1e-5);
    Number("mulT", b2MulT(b2MulT(a, b), b2Vec2(0.3f, 0.4f)), 1e-5);
    Number("angle", b2MulT(a.q, b.q).GetAngle(), 1e-5);
    b2Sweep sweep;
    sweep.localCenter.Set(0.1f, 0.2f);
    sweep.c0.Set(0.0f, 0.0f);
    sweep.c.Set(10.0f, 5.0f);
    sweep.a0 = 7.0f;
    sweep.a = 9.0f;
    sweep.alpha0 = 0.0f;
    sweep.Advance(0.25f);
    sweep.Normalize();
    b2Transform xf;
    sweep.GetTransform(&xf, 0.5f);
    Number("sweep", xf.p, 1e-4);
    Number("a0", sweep.a0, 1e-4);
    b2Vec2 v(3.0f, 4.0f);
    Number("length", v.Normalize());
    Number("index", v(1));
    Say("%u %d %d %d", b2NextPowerOfTwo(37u), b2IsPowerOfTwo(64u), b2IsValid(1.0f), b2Clamp(7, 1, 5));
    Number("cross", b2Cross(2.0f, v));
    Number("skew", v.Skew());
    Number("abs", b2Abs(b2Vec2(-1.0f, 2.0f)));
    Number("slop", b2_linearSlop + b2_maxTranslation + b2_timeToSleep + b2_aabbExtension, 1e-6);
}

namespace {

class CountingDraw : public b2Draw {
public:
    void DrawPolygon(const b2Vec2* vertices, int32 count, const b2Color& color) override {
        Add('P', vertices, count, color);
    }
    void DrawSolidPolygon(const b2Vec2* vertices, int32 count, const b2Color& color) override {
        Add('S', vertices, count, color);
    }
    void DrawCircle(const b2Vec2& center, float, const b2Color& color) override { Add('c', &center, 1, color); }
    void DrawSolidCircle(const b2Vec2& center, float radius, const b2Vec2& axis, const b2Color& color) override {
        Add('C', &center, 1, color);
        Number("radius", radius);
        Number("axis", axis);
    }
    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) override {
        const b2Vec2 ends[] = {p1, p2};
        Add('L', ends, 2, color);
    }
    void DrawTransform(const b2Transform& xf) override { Number("frame", xf.p); }
    void DrawPoint(const b2Vec2& p, float size, const b2Color& color) override {
        Add('p', &p, 1, color);
        Number("size", size);
    }

private:
    static void Add(char kind, const b2Vec2* vertices, int32 count, const b2Color& color) {
        Say("%c %d %.2f %.2f %.2f %.2f", kind, count, color.r, color.g, color.b, color.a);
        for (int32 i = 0; i < count; ++i)
            Number("at", vertices[i], kind == 'P' ? 0.7 : 2e-3);  // boxes are fat in Box2D
    }
};

}  // namespace

void Drawing() {
    b2World world(b2Vec2(0.0f, -10.0f));
    CountingDraw draw;
    world.SetDebugDraw(&draw);
    b2Body* ground = MakeGround(world);
    b2Body* box = MakeBox(world, 0.0f, 3.0f, 0.5f, 0.5f);
    b2Body* disk = MakeDisk(world, 2.0f, 3.0f, 0.5f);
    b2Body* third = MakeBox(world, 5.0f, 3.0f, 0.5f, 0.5f);
    third->SetEnabled(false);
    b2ChainShape chain;
    const b2Vec2 line[] = {b2Vec2(5.0f, 10.0f), b2Vec2(0.0f, 10.0f), b2Vec2(-5.0f, 11.0f)};
    chain.CreateChain(line, 3, b2Vec2(6.0f, 10.0f), b2Vec2(-6.0f, 11.0f));
    ground->CreateFixture(&chain, 0.0f);
    b2RevoluteJointDef revolute;
    revolute.Initialize(ground, box, b2Vec2(0.0f, 4.0f));
    revolute.enableLimit = true;
    revolute.lowerAngle = -0.5f;
    revolute.upperAngle = 0.5f;
    world.CreateJoint(&revolute);
    b2DistanceJointDef distance;
    distance.Initialize(box, disk, box->GetPosition(), disk->GetPosition());
    distance.maxLength = 5.0f;
    distance.minLength = 1.0f;
    world.CreateJoint(&distance);
    b2PrismaticJointDef prismatic;
    prismatic.Initialize(ground, disk, disk->GetPosition(), b2Vec2(1.0f, 0.0f));
    prismatic.enableLimit = true;
    prismatic.lowerTranslation = -1.0f;
    prismatic.upperTranslation = 2.0f;
    world.CreateJoint(&prismatic);
    b2WheelJointDef wheel;
    wheel.Initialize(ground, third, third->GetPosition(), b2Vec2(0.0f, 1.0f));
    world.CreateJoint(&wheel);
    b2WeldJointDef weld;
    weld.Initialize(ground, third, third->GetPosition());
    world.CreateJoint(&weld);
    b2PulleyJointDef pulley;
    pulley.Initialize(box, disk, b2Vec2(0.0f, 9.0f), b2Vec2(2.0f, 9.0f), box->GetPosition(), disk->GetPosition(), 1.0f);
    world.CreateJoint(&pulley);
    b2MouseJointDef mouse;
    mouse.bodyA = ground;
    mouse.bodyB = box;
    mouse.target = box->GetPosition();
    mouse.maxForce = 10.0f;
    mouse.stiffness = 100.0f;
    world.CreateJoint(&mouse);
    world.DebugDraw();  // no flags: nothing
    for (const uint32 flag : {uint32(b2Draw::e_shapeBit), uint32(b2Draw::e_jointBit), uint32(b2Draw::e_aabbBit),
                              uint32(b2Draw::e_centerOfMassBit)}) {
        draw.SetFlags(flag);
        world.DebugDraw();
    }
    draw.AppendFlags(b2Draw::e_pairBit);
    draw.ClearFlags(b2Draw::e_centerOfMassBit);
    Say("flags %u", draw.GetFlags());
}
