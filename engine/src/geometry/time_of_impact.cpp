// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// First touch of two moving convex shapes: proxies and sweeps → time and state. Conservative advancement: GJK gives a
// separating axis at the time reached so far. The separation along it is followed to its first root, and there the next
// axis is taken. Sources: Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (1996), §2.3, for the
// advancement; Box2D 2.4 for the axes that turn with a face, the target distance and the tolerance. New here: the root
// search cannot pass a dip of the separation between two samples. It steps by a bound on the curvature, which is known
// for linear motion of centre and angle.
//
// All happens in the frame of the shape that turns less (A; usually the ground). There B's motion is
//   position p(t) = R(−θA)(d0 + t·d), rotation R(θ0 + t·ω),
// and a point on B follows a path whose second derivative is at most |ωA|(2|d| + |ωA|·max|d0 + t·d|) + ω²·r.

#include "scree/time_of_impact.h"

#include <algorithm>

#include "geometry/gjk.h"

namespace scree {

namespace {

// Ordinary motions take one to four axes and two to ten evaluations, rods that spin at 1e4 rad/s up to 2000.
constexpr int maxAxes = 256;
constexpr int maxEvaluations = 4096;
// The root search aims between the target and the end of the tolerance, so that rounding does not pass the target.
constexpr float aimShare = 0.25f;
// From this turn on, rad, the circles around both cores are compared first: it settles what spins in free space.
constexpr float largeTurn = 1.0f;
// Beyond it the steps vanish anyway, and its square must not overflow.
constexpr float largestCurvature = 1.0e18f;

/// The two cores and their relative motion. A is the one that turns less.
struct Motion {
    Core a, b;
    Vec2 d0, d;               ///< from A's reference point to B's in the world: d0 + t·d
    float angleA, omegaA;     ///< A's angle at time 0 and its change, rad
    float angle, omega;       ///< B's angle seen from A
    Rot qA;                   ///< A's rotation at time 0
    Rot q;                    ///< B's rotation in A's frame at time 0
    Vec2 p0, p;               ///< if A does not turn: d0 and d in A's frame
    float curvatureA = 0.0f;  ///< bound on the second derivative of the separation along an axis fixed in A
    float curvatureB = 0.0f;  ///< the same for an axis fixed in B
};

/// A core about to be put into a Motion.
struct Mover {
    const DistanceProxy* proxy;
    const Sweep* sweep;
    double turn;  ///< change of the angle, rad; 0 if turning does not move the core
};

Mover MakeMover(const DistanceProxy& proxy, const Sweep& sweep) {
    const bool isCentredPoint = proxy.m_count == 1 && proxy.m_vertices[0] == sweep.localCenter;
    return {&proxy, &sweep, isCentredPoint ? 0.0 : static_cast<double>(sweep.a) - static_cast<double>(sweep.a0)};
}

/// Brings an angle near zero, in double because only the remainder has to be a good float.
float Unwind(double radians) {
    constexpr double circle = 6.283185307179586;
    return static_cast<float>(radians - circle * std::nearbyint(radians / circle));
}

/// Largest distance of a core's vertices from a point.
float Radius(const Core& core, Vec2 from) {
    float squared = 0.0f;
    for (int i = 0; i < core.count; ++i) squared = Max(squared, (core.At(i) - from).LengthSquared());
    return std::sqrt(squared);
}

/// Bounds the curvature of the separation for both kinds of axes over [0, tMax].
void BoundCurvature(Motion& m, float tMax) {
    const float speed = m.d.Length();
    const Vec2 end = m.d0 + tMax * m.d;
    const float spinB = Abs(m.omegaA + m.omega);
    if (m.omegaA == 0.0f) {
        m.curvatureA = m.omega * m.omega * Radius(m.b, vec2Zero);
        const float reach = Max(Radius(m.a, m.p0), Radius(m.a, m.p0 + tMax * m.p));
        m.curvatureB = spinB * (2.0f * speed + spinB * reach);
    } else {
        const float spinA = Abs(m.omegaA);
        const float reach = Max(m.d0.Length(), end.Length());
        const float twist = m.omega * m.omega;
        m.curvatureA = spinA * (2.0f * speed + spinA * reach) + twist * Radius(m.b, vec2Zero);
        m.curvatureB = spinB * (2.0f * speed + spinB * reach) + twist * Radius(m.a, vec2Zero);
    }
    m.curvatureA = Min(m.curvatureA, largestCurvature);
    m.curvatureB = Min(m.curvatureB, largestCurvature);
}

Motion MakeMotion(const TOIInput& input) {
    Mover a = MakeMover(input.proxyA, input.sweepA);
    Mover b = MakeMover(input.proxyB, input.sweepB);
    if (std::abs(a.turn) > std::abs(b.turn)) std::swap(a, b);
    const Sweep& sweepA = *a.sweep;
    const Sweep& sweepB = *b.sweep;

    Motion m;
    m.angleA = Unwind(sweepA.a0);
    m.omegaA = static_cast<float>(a.turn);
    m.angle = Unwind(static_cast<double>(sweepB.a0) - static_cast<double>(sweepA.a0));
    m.omega = static_cast<float>(b.turn - a.turn);
    m.qA.Set(m.angleA);
    m.q.Set(m.angle);
    // A body that does not turn may be looked at from anywhere: from its own first vertex, ground far from its body's
    // origin loses no precision.
    const Vec2 originA = m.omegaA == 0.0f ? a.proxy->m_vertices[0] : sweepA.localCenter;
    m.a = Core(a.proxy->m_vertices, a.proxy->m_count, originA);
    m.b = Core(b.proxy->m_vertices, b.proxy->m_count, sweepB.localCenter);
    const Vec2 shift = originA - sweepA.localCenter;
    const Vec2 apart = sweepB.c0 - sweepA.c0;
    m.d0 = apart - Mul(m.qA, shift);
    m.d = (sweepB.c - sweepB.c0) - (sweepA.c - sweepA.c0);
    m.p0 = MulT(m.qA, apart) - shift;
    m.p = MulT(m.qA, m.d);
    if (m.omegaA != 0.0f || m.omega != 0.0f) BoundCurvature(m, input.tMax);
    return m;
}

/// B in A's frame at time t.
Transform PlaceB(const Motion& m, float t) {
    const Rot q = m.omega == 0.0f ? m.q : Rot(m.angle + t * m.omega);
    if (m.omegaA == 0.0f) return {m.p0 + t * m.p, q};
    return {MulT(Rot(m.angleA + t * m.omegaA), m.d0 + t * m.d), q};
}

/// False if a number of the sweeps is NaN or infinite, or their difference overflows.
bool IsFinite(const Motion& m) {
    const Vec2 sum = m.d0 + m.d + m.p0 + m.p + Vec2{m.angleA + m.omegaA, m.angle + m.omega};
    return sum.IsValid();
}

/// A direction that separates the cores, fixed in one of them, and how far that one reaches along it.
struct Axis {
    Vec2 normal;  ///< in the frame of its owner, towards the other
    bool inB;
    float reach;
    float curvature;
};

/// The axis between the nearest features. It turns with B only if the nearest feature is an edge of B alone.
Axis MakeAxis(const Motion& m, const Transform& xfB, const Nearest& nearest) {
    const bool inB = nearest.count == 2 && nearest.indexA[0] == nearest.indexA[1];
    const Vec2 normal = inB ? -MulT(xfB.q, nearest.normal) : nearest.normal;
    return {normal, inB, FindReach(inB ? m.b : m.a, normal), inB ? m.curvatureB : m.curvatureA};
}

/// The gap between the cores along the axis: never more than their distance.
float Separation(const Motion& m, const Axis& axis, const Transform& xfB) {
    if (axis.inB) {
        const Vec2 direction = Mul(xfB.q, axis.normal);
        return -FindReach(m.a, -direction) - Dot(direction, xfB.p) - axis.reach;
    }
    return Dot(axis.normal, xfB.p) - FindReach(m.b, -MulT(xfB.q, axis.normal)) - axis.reach;
}

/// A smooth function has the values `from` > 0 and `to` at the ends of [0, 1] and a second derivative of at most
/// 2·bend in size. Returns a share below which it cannot be negative, more than 1 if it nowhere can. It lies above the
/// parabola from + (to − from)·s − bend·s(1 − s), and so does the least of many such functions.
float SafeShare(float from, float to, float bend) {
    const float fall = bend + (from - to);
    const float discriminant = fall * fall - 4.0f * bend * from;
    if (fall <= 0.0f || discriminant < 0.0f) return 2.0f;
    return 2.0f * from / (fall + std::sqrt(discriminant));
}

/// What the root search works towards: distances of the cores, and the end of the interval.
struct Goal {
    float aim, touch, tMax;
};

/// A time reached, where B is then, and the separation along the axis less the aim.
struct Reached {
    float t;
    Transform xfB;
    float gap;
};

Reached Reach(const Motion& m, const Axis& axis, const Goal& goal, float t) {
    const Transform xfB = PlaceB(m, t);
    return {t, xfB, Separation(m, axis, xfB) - goal.aim};
}

/// Follows the separation along an axis, from a time where it is beyond the aim, to its first root or to the end. Up to
/// the result the cores are at least the aim apart.
Reached Follow(const Motion& m, const Axis& axis, Reached at, const Goal& goal, int& evaluations) {
    float span = goal.tMax - at.t;
    while (evaluations < maxEvaluations) {
        const float end = Min(at.t + span, goal.tMax);
        span = end - at.t;
        const Reached trial = Reach(m, axis, goal, end);
        ++evaluations;
        const float share = SafeShare(at.gap, trial.gap, 0.5f * axis.curvature * span * span);
        if (share > 1.0f) {
            at = trial;
            if (end >= goal.tMax) break;
            span *= 2.0f;
            continue;
        }
        const float t = Min(at.t + share * span, end);
        if (!(t > at.t)) break;
        const Reached next = Reach(m, axis, goal, t);
        ++evaluations;
        const float fall = (at.gap - next.gap) / (t - at.t);
        at = next;
        if (!(at.gap + goal.aim > goal.touch)) break;
        // The next span reaches a little beyond the root foreseen, but no farther than a level start is safe for.
        span = goal.tMax - t;
        if (fall > 0.0f) span = Min(span, 1.5f * at.gap / fall);
        if (axis.curvature > 0.0f) span = Min(span, std::sqrt(8.0f * at.gap / axis.curvature));
    }
    return at;
}

/// True if the circles around both cores stay apart.
bool CirclesStayApart(const Motion& m, const Goal& goal) {
    const float squared = m.d.LengthSquared();
    const float nearest = squared > 0.0f ? Clamp(-Dot(m.d0, m.d) / squared, 0.0f, goal.tMax) : 0.0f;
    const float radii = Radius(m.a, vec2Zero) + Radius(m.b, vec2Zero);
    return (m.d0 + nearest * m.d).Length() > radii + goal.touch;
}

/// The state after GJK at a time up to which nothing touches, or e_unknown if the search must go on.
TOIOutput::State Judge(const Nearest& nearest, float t, const Goal& goal) {
    if (!std::isfinite(nearest.distance)) return TOIOutput::e_failed;
    if (nearest.distance == 0.0f && t == 0.0f) return TOIOutput::e_overlapped;
    if (nearest.distance < goal.touch) return TOIOutput::e_touching;
    return t >= goal.tMax ? TOIOutput::e_separated : TOIOutput::e_unknown;
}

void Advance(TOIOutput& output, const Motion& m, const Goal& goal) {
    const float turn = goal.tMax * (Abs(m.omegaA) + Abs(m.omega));
    Reached at{0.0f, {m.p0, m.q}, 0.0f};
    SimplexCache cache;
    for (; output.iterations < maxAxes; output.iterations += 1) {
        const Nearest nearest = FindNearest(m.a, m.b, at.xfB, cache);
        output.distanceCalls += 1;
        output.distanceIterations += nearest.iterations;
        output.maxDistanceIterations = std::max(output.maxDistanceIterations, nearest.iterations);
        output.t = at.t;
        output.state = Judge(nearest, at.t, goal);
        if (output.state != TOIOutput::e_unknown) return;
        if (output.iterations == 0 && turn > largeTurn && CirclesStayApart(m, goal)) break;

        at.gap = nearest.distance - goal.aim;
        at = Follow(m, MakeAxis(m, at.xfB, nearest), at, goal, output.rootIterations);
        if (at.t >= goal.tMax && at.gap + goal.aim > goal.touch) break;
        if (!(at.t > output.t)) {
            // The next touch is nearer than floats can tell times apart, or the evaluations are used up.
            output.state = output.rootIterations < maxEvaluations ? TOIOutput::e_touching : TOIOutput::e_failed;
            return;
        }
    }
    const bool isApart = output.iterations < maxAxes;
    output.state = isApart ? TOIOutput::e_separated : TOIOutput::e_failed;
    output.t = isApart ? goal.tMax : at.t;
}

}  // namespace

void TimeOfImpact(TOIOutput* output, const TOIInput* input) {
    *output = {};
    output->state = TOIOutput::e_failed;
    const bool isEmpty = input->proxyA.m_count < 1 || input->proxyB.m_count < 1;
    if (isEmpty || !(input->tMax >= 0.0f)) return;
    const float target = TOITarget(input->proxyA.m_radius + input->proxyB.m_radius, input->lengthScale);
    const float tolerance = toiTolerance * input->lengthScale;
    const Goal goal{target + aimShare * tolerance, target + tolerance, input->tMax};
    const Motion motion = MakeMotion(*input);
    if (IsFinite(motion)) Advance(*output, motion, goal);
}

void TOIStats::Add(const TOIOutput& output) {
    calls += 1;
    iterations += output.iterations;
    maxIterations = std::max(maxIterations, output.iterations);
    rootIterations += output.rootIterations;
    maxRootIterations = std::max(maxRootIterations, output.rootIterations);
    distanceCalls += output.distanceCalls;
    distanceIterations += output.distanceIterations;
    maxDistanceIterations = std::max(maxDistanceIterations, output.maxDistanceIterations);
}

}  // namespace scree
