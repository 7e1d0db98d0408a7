// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Greedy colouring with a set of 64 colours a body (as in Box2D 3), in as many rounds as the busiest body needs: a
// dense cluster never falls back to a serial rest. Contacts with bodies that cannot be pushed come last in every pass,
// so that the ground has the last word; they conflict on one body only.

#include "constraints/contact_blocks.h"

#include <algorithm>
#include <bit>

#include "scree/settings.h"

namespace scree {

namespace {

// Bits of m_class.
constexpr uint8_t fixedBit = 1;    ///< one body cannot be pushed
constexpr uint8_t swappedBit = 2;  ///< …and it is the contact's B
constexpr uint8_t twoPointBit = 4;
constexpr int kindCount = 2;  ///< of points within a colour
constexpr int coloursPerRound = 64;

/// A contact seen from its block: side B can be pushed.
struct Sides {
    int a, b;
    bool swapped;
};
Sides SidesOf(const ContactPair& pair, uint8_t kind) {
    const bool swapped = (kind & swappedBit) != 0;
    return swapped ? Sides{pair.bodyB, pair.bodyA, true} : Sides{pair.bodyA, pair.bodyB, false};
}

/// Lanes to spare: the first lane's bodies, no mass.
void FillSpare(ContactBlock& block, int lane) {
    block.bodyA[lane] = block.bodyA[0];
    block.bodyB[lane] = block.bodyB[0];
    block.slot[lane] = -1;
    for (ContactBlock::Row* row : {&block.invMassA,
                                   &block.invMassB,
                                   &block.invIA,
                                   &block.invIB,
                                   &block.normalX,
                                   &block.normalY,
                                   &block.armA[0],
                                   &block.armA[1],
                                   &block.armB[0],
                                   &block.armB[1],
                                   &block.tangentArmA,
                                   &block.tangentArmB,
                                   &block.normalImpulse[0],
                                   &block.normalImpulse[1],
                                   &block.tangentImpulse,
                                   &block.friction,
                                   &block.tangentSpeed,
                                   &block.restitution,
                                   &block.restitutionThreshold,
                                   &block.bias[0],
                                   &block.bias[1],
                                   &block.bounceSpeed[0],
                                   &block.bounceSpeed[1],
                                   &block.totalNormal[0],
                                   &block.totalNormal[1],
                                   &block.totalTangent}) {
        (*row)[lane] = 0.0f;
    }
    block.separation[0][lane] = block.separation[1][lane] = 1.0f;  // no overlap
}

/// What Fill reads of one contact.
struct LaneInput {
    const BlockInput& in;
    int contact;
    Sides sides;
};

void FillPoints(const LaneInput& lane, ContactBlock& block, int l) {
    const auto c = static_cast<size_t>(lane.contact);
    const BodyTable& bodies = lane.in.bodies;
    const ContactPair& pair = lane.in.contacts.pair[c];
    const Manifold& m = lane.in.contacts.manifold[c];
    const ContactMaterial& material = lane.in.contacts.material[c];
    const auto a = static_cast<size_t>(lane.sides.a), b = static_cast<size_t>(lane.sides.b);

    WorldManifold world;
    world.Initialize(&m, bodies.transform[static_cast<size_t>(pair.bodyA)],
                     lane.in.fixtures.shape[pair.fixtureA]->m_radius, bodies.transform[static_cast<size_t>(pair.bodyB)],
                     lane.in.fixtures.shape[pair.fixtureB]->m_radius);
    const Vec2 normal = lane.sides.swapped ? -world.normal : world.normal;
    const Vec2 tangent = Cross(normal, 1.0f);
    block.normalX[l] = normal.x;
    block.normalY[l] = normal.y;

    const Velocity& vA = bodies.velocity[a];
    const Velocity& vB = bodies.velocity[b];
    const bool atSurface = lane.in.onMoverSurface && bodies.type[a] != dynamicBody;
    Vec2 middle = vec2Zero;
    float push = 0.0f;
    for (int i = 0; i < m.pointCount; ++i) {
        const Vec2 rA = world.points[i] - bodies.position[a].c;
        const Vec2 rB = world.points[i] - bodies.position[b].c;
        middle += atSurface ? world.points[i] + 0.5f * world.separations[i] * normal : world.points[i];
        block.armA[i][l] = Cross(rA, normal);
        block.armB[i][l] = Cross(rB, normal);
        block.separation[i][l] = world.separations[i] + lane.in.slop;
        block.normalImpulse[i][l] = lane.in.impulseScale * m.points[i].normalImpulse;
        push += m.points[i].tangentImpulse;
        block.totalNormal[i][l] = 0.0f;
        block.bounceSpeed[i][l] = block.bias[i][l] = 0.0f;
        if (!lane.in.restitution) continue;
        const float closing = Dot(normal, vB.v + Cross(vB.w, rB) - vA.v - Cross(vA.w, rA));
        const bool leaves = closing < -material.restitutionThreshold;
        block.bias[i][l] = leaves ? -material.restitution * closing : 0.0f;
    }
    middle *= m.pointCount == 2 ? 0.5f : 1.0f;
    block.tangentArmA[l] = Cross(middle - bodies.position[a].c, tangent);
    block.tangentArmB[l] = Cross(middle - bodies.position[b].c, tangent);
    block.tangentImpulse[l] = lane.in.impulseScale * push;
    block.totalTangent[l] = 0.0f;
}

void FillLane(const LaneInput& lane, ContactBlock& block, int l, int slot) {
    const MassRow& massA = lane.in.bodies.mass[static_cast<size_t>(lane.sides.a)];
    const MassRow& massB = lane.in.bodies.mass[static_cast<size_t>(lane.sides.b)];
    const ContactMaterial& material = lane.in.contacts.material[static_cast<size_t>(lane.contact)];
    block.bodyA[l] = lane.sides.a;
    block.bodyB[l] = lane.sides.b;
    block.slot[l] = slot;
    block.invMassA[l] = massA.invMass;
    block.invMassB[l] = massB.invMass;
    block.invIA[l] = massA.invI;
    block.invIB[l] = massB.invI;
    block.friction[l] = material.friction;
    block.tangentSpeed[l] = material.tangentSpeed;
    block.restitution[l] = material.restitution;
    block.restitutionThreshold[l] = material.restitutionThreshold;
    FillPoints(lane, block, l);
}

}  // namespace

void ContactBlocks::Sort(const BlockInput& input) {
    const size_t count = input.list.size();
    m_list = input.list;
    m_class.resize(count);
    m_colours.resize(count);
    m_lane.resize(count);
    m_movers.clear();
    m_fixed.clear();
    for (size_t i = 0; i < count; ++i) {
        const auto c = static_cast<size_t>(input.list[i]);
        const ContactPair& pair = input.contacts.pair[c];
        const bool movesA = input.bodies.type[static_cast<size_t>(pair.bodyA)] == dynamicBody;
        const bool movesB = input.bodies.type[static_cast<size_t>(pair.bodyB)] == dynamicBody;
        uint8_t kind = input.contacts.manifold[c].pointCount == 2 ? twoPointBit : 0;
        if (!movesA || !movesB) kind |= fixedBit;
        if (!movesB) kind |= swappedBit;
        m_class[i] = kind;
        ((kind & fixedBit) != 0 ? m_fixed : m_movers).push_back(static_cast<int>(i));
    }
}

void ContactBlocks::ColourMovers(const BlockInput& input) {
    m_left = m_movers;
    int base = 0;
    while (!m_left.empty()) {
        for (const int i : m_left) {
            const ContactPair& pair = input.contacts.pair[static_cast<size_t>(input.list[static_cast<size_t>(i)])];
            m_used[static_cast<size_t>(pair.bodyA)] = m_used[static_cast<size_t>(pair.bodyB)] = 0;
        }
        m_next.clear();
        int highest = -1;
        for (const int i : m_left) {
            const ContactPair& pair = input.contacts.pair[static_cast<size_t>(input.list[static_cast<size_t>(i)])];
            uint64_t& usedA = m_used[static_cast<size_t>(pair.bodyA)];
            uint64_t& usedB = m_used[static_cast<size_t>(pair.bodyB)];
            const uint64_t free = ~(usedA | usedB);
            if (free == 0) {
                m_next.push_back(i);
                continue;
            }
            const int colour = std::countr_zero(free);
            usedA |= uint64_t{1} << colour;
            usedB |= uint64_t{1} << colour;
            m_colours[static_cast<size_t>(i)] = base + colour;
            highest = colour > highest ? colour : highest;
        }
        base += highest + 1;
        m_left.swap(m_next);
    }
    m_colourCount = m_moverColourCount = base;
}

void ContactBlocks::ColourFixed(const BlockInput& input) {
    // The k-th contact of a body with the unmovable has the k-th colour.
    const auto bodyOf = [&](int i) {
        const auto at = static_cast<size_t>(i);
        return static_cast<size_t>(SidesOf(input.contacts.pair[static_cast<size_t>(input.list[at])], m_class[at]).b);
    };
    for (const int i : m_fixed) m_used[bodyOf(i)] = 0;
    int most = 0;
    for (const int i : m_fixed) {
        const int colour = static_cast<int>(m_used[bodyOf(i)]++);
        m_colours[static_cast<size_t>(i)] = m_colourCount + colour;
        most = colour + 1 > most ? colour + 1 : most;
    }
    m_colourCount += most;
}

void ContactBlocks::MakeRanges(const BlockInput& input) {
    // Counting sort by (colour, points) into blocks.
    const auto groupOf = [&](size_t i) {
        return static_cast<size_t>(m_colours[i] * kindCount + ((m_class[i] & twoPointBit) != 0 ? 1 : 0));
    };
    const size_t groupCount = static_cast<size_t>(m_colourCount * kindCount);
    m_start.assign(groupCount, 0);
    for (size_t i = 0; i < input.list.size(); ++i) ++m_start[groupOf(i)];
    m_ranges.clear();
    int block = 0;
    for (size_t g = 0; g < groupCount; ++g) {
        const int lanes = m_start[g];
        const int blocks = (lanes + blockLanes - 1) / blockLanes;
        const bool fixedA = static_cast<int>(g / kindCount) >= m_moverColourCount;
        if (blocks > 0) m_ranges.push_back({block, block + blocks, {fixedA, g % kindCount == 1}});
        m_start[g] = block * blockLanes;
        block += blocks;
    }
    m_blocks.resize(static_cast<size_t>(block));
    m_order.assign(m_blocks.size() * blockLanes, -1);
    for (size_t i = 0; i < input.list.size(); ++i) {
        m_lane[i] = m_start[groupOf(i)]++;
        m_order[static_cast<size_t>(m_lane[i])] = static_cast<int>(i);
    }
}

void ContactBlocks::Prefetch(const BlockInput& input, size_t block) const {
#if defined(__GNUC__)
    // Contacts of a colour are far apart: ask for those of the block after next, and for the bodies of the next.
    const auto contactAt = [&](size_t lane) {
        const int i = lane < m_order.size() ? m_order[lane] : -1;
        return i < 0 ? size_t{0} : static_cast<size_t>(input.list[static_cast<size_t>(i)]);
    };
    for (size_t l = 0; l < blockLanes; ++l) {
        const size_t far = contactAt((block + 2) * blockLanes + l);
        __builtin_prefetch(&input.contacts.pair[far]);
        __builtin_prefetch(&input.contacts.manifold[far]);
        __builtin_prefetch(&input.contacts.material[far]);
        const ContactPair& pair = input.contacts.pair[contactAt((block + 1) * blockLanes + l)];
        for (const int body : {pair.bodyA, pair.bodyB}) {
            __builtin_prefetch(&input.bodies.transform[static_cast<size_t>(body)]);
            __builtin_prefetch(&input.bodies.position[static_cast<size_t>(body)]);
            __builtin_prefetch(&input.bodies.velocity[static_cast<size_t>(body)]);
            __builtin_prefetch(&input.bodies.mass[static_cast<size_t>(body)]);
        }
        __builtin_prefetch(&input.fixtures.shape[pair.fixtureA]);
        __builtin_prefetch(&input.fixtures.shape[pair.fixtureB]);
    }
#endif
}

/// Fills blocks [begin, end); true if a contact of them bounces.
bool ContactBlocks::FillRange(const BlockInput& input, size_t begin, size_t end) {
    // Block by block, so that the rows of one stay in the nearest cache while its lanes are written.
    bool bounces = false;
    for (size_t k = begin; k < end; ++k) {
        ContactBlock& block = m_blocks[k];
        Prefetch(input, k);
        for (int l = 0; l < blockLanes; ++l) {
            const int i = m_order[k * blockLanes + static_cast<size_t>(l)];
            if (i < 0) {
                FillSpare(block, l);
                continue;
            }
            const int contact = input.list[static_cast<size_t>(i)];
            const ContactPair& pair = input.contacts.pair[static_cast<size_t>(contact)];
            FillLane({input, contact, SidesOf(pair, m_class[static_cast<size_t>(i)])}, block, l, i);
            bounces |= input.contacts.material[static_cast<size_t>(contact)].restitution > 0.0f;
        }
    }
    return bounces;
}

void ContactBlocks::Fill(const BlockInput& input) {
    constexpr int leastBlocksToFill = 16;
    bool bounces[maxWorkers] = {};
    input.pool.For(static_cast<int>(m_blocks.size()), leastBlocksToFill, [&](int begin, int end, int worker) {
        bounces[worker] |= FillRange(input, static_cast<size_t>(begin), static_cast<size_t>(end));
    });
    m_bounces = std::find(std::begin(bounces), std::end(bounces), true) != std::end(bounces);
}

void ContactBlocks::Build(const BlockInput& input) {
    m_used.resize(static_cast<size_t>(input.bodies.slots.Size()));
    Sort(input);
    ColourMovers(input);
    ColourFixed(input);
    MakeRanges(input);
    Fill(input);
}

void ContactBlocks::Store(float scale, std::vector<Manifold>& manifold) const {
    for (const ContactBlock& block : m_blocks) {
        for (int l = 0; l < blockLanes; ++l) {
            if (block.slot[l] < 0) continue;
            Manifold& m = manifold[static_cast<size_t>(m_list[static_cast<size_t>(block.slot[l])])];
            // One friction row serves both points: half each.
            const float tangent = scale * block.tangentImpulse[l] * (m.pointCount == 2 ? 0.5f : 1.0f);
            for (int p = 0; p < m.pointCount; ++p) {
                m.points[p].normalImpulse = scale * block.normalImpulse[p][l];
                m.points[p].tangentImpulse = tangent;
            }
        }
    }
}

void ContactBlocks::GetImpulses(bool summed, std::vector<ContactImpulse>& impulses) const {
    impulses.resize(m_list.size());
    for (size_t i = 0; i < m_list.size(); ++i) {
        const ContactBlock& block = m_blocks[static_cast<size_t>(m_lane[i] / blockLanes)];
        const int l = m_lane[i] % blockLanes;
        ContactImpulse& out = impulses[i];
        out.count = (m_class[i] & twoPointBit) != 0 ? 2 : 1;
        const float tangent = (summed ? block.totalTangent : block.tangentImpulse)[l] / static_cast<float>(out.count);
        for (int p = 0; p < out.count; ++p) {
            out.normalImpulses[p] = (summed ? block.totalNormal : block.normalImpulse)[p][l];
            out.tangentImpulses[p] = tangent;
        }
    }
}

KernelTask ContactBlocks::Task(std::vector<Velocity>& velocity, std::vector<Velocity>& delta) {
    static_assert(sizeof(Velocity) == 4 * sizeof(float));
    return {.blocks = m_blocks.data(),
            .ranges = m_ranges.data(),
            .rangeCount = static_cast<int32_t>(m_ranges.size()),
            .velocity = &velocity.data()->v.x,
            .delta = &delta.data()->v.x,
            .soft = {},
            .sumImpulses = false,
            .friction = true};
}

}  // namespace scree
