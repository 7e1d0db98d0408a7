// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the bound of a passage calls sure, the search for the time of impact finds free. So it does within its slack on
// any other way. Shapes are of every kind, slow and fast, turning, near and far from the origin, at rest on each other
// and apart.

#include "geometry/passage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scree/time_of_impact.h"
#include "tests/geometry/any_shape.h"
#include "tests/geometry/source.h"

namespace scree::test {
namespace {

struct Moving {
    AnyShape still, mover;
    Vec2 centre;               ///< of the mover, local
    Sweep sweepA, sweepB;      ///< still, mover
    Transform placeA, placeB;  ///< at the end
};

Transform EndOf(const Sweep& sweep) {
    Transform xf;
    sweep.GetTransform(&xf, 1.0f);
    return xf;
}

void SetMotion(Moving& m, Vec2 endCentre, float endAngle, Vec2 way, float turn) {
    m.sweepB.localCenter = m.centre;
    m.sweepB.c = endCentre, m.sweepB.c0 = endCentre - way;
    m.sweepB.a = endAngle, m.sweepB.a0 = endAngle - turn;
    m.sweepB.alpha0 = 0.0f;
    m.placeB = EndOf(m.sweepB);
}

bool Meets(const DistanceProxy& a, const DistanceProxy& b, const Moving& m, float lengthScale, TOIOutput& output) {
    TOIInput input;
    input.proxyA = a, input.proxyB = b;
    input.sweepA = m.sweepA, input.sweepB = m.sweepB;
    input.tMax = 1.0f;
    input.lengthScale = lengthScale;
    TimeOfImpact(&output, &input);
    return output.state == TOIOutput::e_touching || output.state == TOIOutput::e_overlapped;
}

/// As the stage of continuous collision judges a search (ToiPairs::TimeOf).
bool HasEvent(const Moving& m, Watched watched, float lengthScale) {
    DistanceProxy a, b;
    a.Set(m.still.shape, 0), b.Set(m.mover.shape, 0);
    TOIOutput output;
    if (watched != Watched::middle && !Meets(a, b, m, lengthScale, output)) return false;
    if (watched == Watched::cores || (watched == Watched::coresOrMiddle && output.t > 0.0f)) return true;
    const Vec2 middle = MiddleOf(*m.mover.shape);
    b.Set(&middle, 1, 0.0f);
    return Meets(a, b, m, lengthScale, output);
}

/// Puts the mover so that its core and the still one are about `gap` apart at the end.
void PutNear(Moving& m, float gap, Source& random) {
    DistanceInput input{};  // without radii
    input.proxyA.Set(m.still.shape, 0), input.proxyB.Set(m.mover.shape, 0);
    input.transformA = m.placeA;
    for (int round = 0; round < 4; ++round) {
        input.transformB = m.placeB;
        SimplexCache cache;
        cache.count = 0;
        DistanceOutput output;
        Distance(&output, &cache, &input);
        Vec2 apart = output.pointB - output.pointA;
        const float distance = apart.Normalize();
        const Vec2 shift = distance > 0.0f ? (gap - distance) * apart : 0.1f * random.Direction();
        SetMotion(m, m.sweepB.c + shift, m.sweepB.a, m.sweepB.c - m.sweepB.c0, m.sweepB.a - m.sweepB.a0);
    }
}

TEST(Passage, IsSureOnlyWhereNothingMeets) {
    Source random(5);
    int sure[3] = {}, met = 0, slackened = 0, resting = 0, passing = 0;
    for (int i = 0; i < 120000; ++i) {
        Moving m;
        const float lengthScale = random.Below(4) == 0 ? random.Size(0.1f, 10.0f) : 1.0f;
        const float size = lengthScale * random.Size(0.05f, 5.0f);
        MakeShape(m.still, size * random.Size(0.2f, random.Below(4) == 0 ? 2000.0f : 20.0f), random);
        MakeShape(m.mover, size, random);
        const Vec2 origin = random.Below(3) == 0 ? random.InSquare(1500.0f) : Vec2{0.0f, 0.0f};
        m.sweepA.localCenter = {0.0f, 0.0f};
        m.sweepA.c0 = m.sweepA.c = origin;
        m.sweepA.a0 = m.sweepA.a = random.Below(2) == 0 ? 0.0f : random.Between(-pi, pi);
        m.sweepA.alpha0 = 0.0f;
        m.placeA = EndOf(m.sweepA);
        m.centre = random.Below(2) == 0 ? MiddleOf(*m.mover.shape) : random.InSquare(size);
        const Vec2 way = random.Below(8) == 0 ? Vec2{0.0f, 0.0f} : random.Size(1e-6f, 3.0f) * size * random.Direction();
        const float turn =
            random.Below(3) == 0 ? 0.0f : random.Size(1e-6f, 2.0f) * (random.Below(2) == 0 ? 1.0f : -1.0f);
        SetMotion(m, origin + random.InSquare(3.0f * size), random.Between(-pi, pi), way, turn);
        if (random.Below(2) == 0) {
            // About where contacts hold bodies: skins that overlap by some slops, or outlines.
            const float radii = m.still.shape->m_radius + m.mover.shape->m_radius;
            const float slop = linearSlop * lengthScale;
            PutNear(m, Max(0.0f, radii + random.Between(-6.0f, 3.0f) * slop), random);
        }
        for (const Watched watched : {Watched::cores, Watched::coresOrMiddle, Watched::middle}) {
            const auto bound = [&](Vec2 way2, float turn2) {
                return BoundClearance({*m.still.shape, m.placeA, *m.mover.shape, m.placeB, m.centre, way2, turn2},
                                      watched, lengthScale);
            };
            const Clearance clearance = bound(m.sweepB.c - m.sweepB.c0, m.sweepB.a - m.sweepB.a0);
            const bool meets = HasEvent(m, watched, lengthScale);
            met += meets ? 1 : 0;
            if (watched == Watched::coresOrMiddle && clearance.middlePasses) {
                ++passing;
                EXPECT_FALSE(HasEvent(m, Watched::middle, lengthScale)) << "case " << i;
            }
            if (clearance.isSure) {
                ++sure[static_cast<int>(watched)];
                resting += watched == Watched::coresOrMiddle && HasEvent(m, Watched::cores, lengthScale) ? 1 : 0;
                EXPECT_FALSE(meets) << "case " << i << " watched " << static_cast<int>(watched);
            }
            if (clearance.slack > 0.0f) {
                // Two places within the slack of the end, and the way between them.
                const auto within = [&](Vec2& c, float& a) {
                    const float share = random.Between(0.0f, 1.0f);
                    c += (share * clearance.slack) * random.Direction();
                    a += (1.0f - share) * random.Between(-1.0f, 1.0f) * clearance.slack / Max(clearance.reach, 1e-3f);
                };
                Moving other = m;
                Vec2 from = m.sweepB.c, to = m.sweepB.c;
                float fromAngle = m.sweepB.a, toAngle = m.sweepB.a;
                within(from, fromAngle), within(to, toAngle);
                SetMotion(other, to, toAngle, to - from, toAngle - fromAngle);
                ++slackened;
                EXPECT_FALSE(HasEvent(other, watched, lengthScale)) << "case " << i << ", slack " << clearance.slack;
            }
        }
    }
    EXPECT_GT(sure[0], 20000);
    EXPECT_GT(sure[1], 20000);
    EXPECT_GT(sure[2], 20000);
    EXPECT_GT(resting, 500);
    EXPECT_GT(slackened, 40000);
    EXPECT_GT(passing, 20000);
    EXPECT_GT(met, 20000);
}

/// A box that lies on long ground, slides along it and creeps into it is sure in both ways of resting.
TEST(Passage, IsSureWhereABoxRestsOrSlides) {
    Source random(6);
    for (int i = 0; i < 500; ++i) {
        EdgeShape ground;
        ground.SetTwoSided({-100.0f, 0.0f}, {100.0f, 0.0f});
        PolygonShape box;
        const float height = random.Between(0.1f, 2.0f);
        box.SetAsBox(random.Between(0.1f, 2.0f), height);
        const Transform place{{random.Between(-80.0f, 80.0f), 0.0f}, Rot(0.0f)};
        const Vec2 way{random.Between(-1.0f, 1.0f), random.Between(-0.002f, 0.002f)};
        for (const Watched watched : {Watched::cores, Watched::coresOrMiddle}) {
            Transform at = place;
            at.p.y = height + (watched == Watched::cores ? 3.0f : random.Between(-0.3f, 0.3f)) * linearSlop;
            const Clearance clearance =
                BoundClearance({ground, {{0.0f, 0.0f}, Rot(0.0f)}, box, at, {0.0f, 0.0f}, way, 1e-4f}, watched, 1.0f);
            EXPECT_TRUE(clearance.isSure) << i;
            EXPECT_GT(clearance.slack, 0.5f * linearSlop) << i;
        }
    }
}

/// A disk that rolls over a hill of short segments comes no nearer to the ends of those beside it, though it is below
/// the lines through them.
TEST(Passage, IsSureBesideTheEndsOfSegments) {
    Source random(7);
    for (int i = 0; i < 500; ++i) {
        CircleShape disk;
        disk.m_radius = random.Between(0.2f, 0.5f);
        const float fall = random.Between(0.05f, 0.6f), side = random.Below(2) == 0 ? 1.0f : -1.0f;
        const Vec2 corner{side * disk.m_radius * random.Between(0.5f, 1.0f), 0.0f};
        EdgeShape beside;
        beside.SetTwoSided(corner, corner + Vec2{side * std::cos(fall), -std::sin(fall)});
        const Vec2 way{random.Between(-0.01f, 0.01f), 0.0f};
        const Passage passage{
            beside, {{0.0f, 0.0f}, Rot(0.0f)}, disk, {{0.0f, disk.m_radius}, Rot(0.0f)}, vec2Zero, way, 0.0f};
        EXPECT_TRUE(BoundClearance(passage, Watched::coresOrMiddle, 1.0f).isSure) << i;
    }
}

/// A box that rocks and slides on short segments is sure of those beside its corners and of those under it, which its
/// core overlaps.
TEST(Passage, IsSureWhereABoxRocksOnShortSegments) {
    Source random(8);
    int sure = 0, overlaps = 0, all = 0;
    for (int i = 0; i < 500; ++i) {
        PolygonShape box;
        const Vec2 half{random.Between(0.3f, 0.6f), random.Between(0.2f, 0.4f)};
        box.SetAsBox(half.x, half.y);
        const float bend = random.Between(0.02f, 0.1f);
        const auto ground = [&](float x) { return Vec2{x, -bend * x * x}; };
        const Vec2 way{random.Between(-0.05f, 0.05f), 0.0f};
        const float turn = random.Between(-0.02f, 0.02f);
        const Transform place{{0.5f * way.x, half.y - 0.001f}, Rot(0.5f * turn)};
        for (float x = -1.0f; x < 1.0f; x += 0.1f) {
            EdgeShape edge;
            edge.SetTwoSided(ground(x), ground(x + 0.1f));
            const Passage passage{edge, {{0.0f, 0.0f}, Rot(0.0f)}, box, place, vec2Zero, way, turn};
            const bool isSure = BoundClearance(passage, Watched::coresOrMiddle, 1.0f).isSure;
            ++all;
            sure += isSure ? 1 : 0;
            overlaps += isSure && !BoundClearance(passage, Watched::cores, 1.0f).isSure ? 1 : 0;
        }
    }
    EXPECT_GT(sure, all * 9 / 10);
    EXPECT_GT(overlaps, all / 20);
}

}  // namespace
}  // namespace scree::test
