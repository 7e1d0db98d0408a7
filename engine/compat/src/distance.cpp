// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Distance, shape cast and time of impact on proxies of the program's vertices, with Box2D's counters.

#include "../box2d/b2_distance.h"

#include <array>
#include <chrono>

#include "../box2d/b2_time_of_impact.h"
#include "convert.h"
#include "counters.h"
#include "scree/distance.h"
#include "scree/time_of_impact.h"

// Box2D exports its counters without declaring them; programs that read them declare them themselves.
int32 b2_gjkCalls = 0, b2_gjkIters = 0, b2_gjkMaxIters = 0;
float b2_toiTime = 0.0f, b2_toiMaxTime = 0.0f;
int32 b2_toiCalls = 0, b2_toiIters = 0, b2_toiMaxIters = 0;
int32 b2_toiRootIters = 0, b2_toiMaxRootIters = 0;

using namespace scree::box2d;

void b2DistanceProxy::Set(const b2Shape* shape, int32 index) {
    m_vertices = nullptr;
    m_count = 0;
    m_radius = 0.0f;
    if (shape == nullptr || index < 0 || index >= shape->GetChildCount()) {
        return Complain("b2DistanceProxy::Set", "give a shape and one of its children");
    }
    switch (shape->GetType()) {
        case b2Shape::e_circle:
            Set(&static_cast<const b2CircleShape*>(shape)->m_p, 1, shape->m_radius);
            break;
        case b2Shape::e_polygon: {
            const auto* polygon = static_cast<const b2PolygonShape*>(shape);
            Set(polygon->m_vertices, polygon->m_count, shape->m_radius);
            break;
        }
        // Two ends are kept here, as in Box2D: an edge's are no array, and a loop may be rebuilt.
        case b2Shape::e_edge: {
            const auto* edge = static_cast<const b2EdgeShape*>(shape);
            m_buffer[0] = edge->m_vertex1;
            m_buffer[1] = edge->m_vertex2;
            Set(m_buffer, 2, shape->m_radius);
            break;
        }
        default: {
            const auto* chain = static_cast<const b2ChainShape*>(shape);
            m_buffer[0] = chain->m_vertices[index];
            m_buffer[1] = chain->m_vertices[index + 1];
            Set(m_buffer, 2, shape->m_radius);
            break;
        }
    }
}

void b2DistanceProxy::Set(const b2Vec2* vertices, int32 count, float radius) {
    m_vertices = vertices;
    m_count = count;
    m_radius = radius;
}

namespace {

/// The engine's view of a proxy: its own copy of the vertices.
struct Points {
    /// `length`: factor on all lengths.
    explicit Points(const b2DistanceProxy& source, float length = 1.0f) {
        const int count = std::clamp(source.m_count, 0, static_cast<int>(inPlace.size()));
        for (int i = 0; i < count; ++i) inPlace[static_cast<size_t>(i)] = length * ToScree(source.m_vertices[i]);
        if (count > 0) proxy.Set(inPlace.data(), count, length * source.m_radius);
    }
    Points(const Points&) = delete;
    Points& operator=(const Points&) = delete;

    std::array<scree::Vec2, 255> inPlace;  // what an index of a simplex can name
    scree::DistanceProxy proxy;
};

}  // namespace

void b2Distance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceInput* input) {
    const Points a(input->proxyA);
    const Points b(input->proxyB);
    scree::DistanceInput in{a.proxy, b.proxy, ToScree(input->transformA), ToScree(input->transformB), input->useRadii};
    scree::SimplexCache simplex;
    simplex.metric = cache->metric;
    simplex.count = cache->count <= 3 ? cache->count : uint16_t{0};
    std::copy_n(cache->indexA, simplex.count, simplex.indexA);
    std::copy_n(cache->indexB, simplex.count, simplex.indexB);
    scree::DistanceOutput out{};
    scree::Distance(&out, &simplex, &in);
    cache->metric = simplex.metric;
    cache->count = simplex.count;
    std::copy_n(simplex.indexA, simplex.count, cache->indexA);
    std::copy_n(simplex.indexB, simplex.count, cache->indexB);
    output->pointA = ToBox2d(out.pointA);
    output->pointB = ToBox2d(out.pointB);
    output->distance = out.distance;
    output->iterations = out.iterations;
    CountDistance(1, out.iterations, out.iterations);
}

bool b2ShapeCast(b2ShapeCastOutput* output, const b2ShapeCastInput* input) {
    // The engine's tolerances of a cast are in metres.
    const Points a(input->proxyA, metres);
    const Points b(input->proxyB, metres);
    scree::ShapeCastInput in{a.proxy, b.proxy, ToScree(input->transformA), ToScree(input->transformB),
                             metres * ToScree(input->translationB)};
    in.transformA.p *= metres;
    in.transformB.p *= metres;
    scree::ShapeCastOutput out{};
    const bool hit = scree::ShapeCast(&out, &in);
    output->point = ToBox2d(b2_lengthUnitsPerMeter * out.point);
    output->normal = ToBox2d(out.normal);
    output->lambda = out.lambda;
    output->iterations = out.iterations;
    return hit;
}

void b2TimeOfImpact(b2TOIOutput* output, const b2TOIInput* input) {
    const auto start = std::chrono::steady_clock::now();
    const Points a(input->proxyA);
    const Points b(input->proxyB);
    scree::TOIInput in{
        a.proxy, b.proxy, ToScree(input->sweepA), ToScree(input->sweepB), input->tMax, b2_lengthUnitsPerMeter};
    scree::TOIOutput out{};
    scree::TimeOfImpact(&out, &in);
    output->state = static_cast<b2TOIOutput::State>(out.state);
    output->t = out.t;
    scree::TOIStats stats;
    stats.Add(out);
    const float time = std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - start).count();
    CountToi(stats, time);
    b2_toiMaxTime = b2Max(b2_toiMaxTime, time);
}

namespace scree::box2d {

void CountDistance(int calls, int iterations, int maxIterations) {
    b2_gjkCalls += calls;
    b2_gjkIters += iterations;
    b2_gjkMaxIters = b2Max(b2_gjkMaxIters, maxIterations);
}

void CountToi(const TOIStats& stats, float time) {
    if (stats.calls > 0) b2_toiTime += time;
    CountDistance(stats.distanceCalls, stats.distanceIterations, stats.maxDistanceIterations);
    b2_toiCalls += stats.calls;
    b2_toiIters += stats.iterations;
    b2_toiMaxIters = b2Max(b2_toiMaxIters, stats.maxIterations);
    b2_toiRootIters += stats.rootIterations;
    b2_toiMaxRootIters = b2Max(b2_toiMaxRootIters, stats.maxRootIterations);
}

}  // namespace scree::box2d
