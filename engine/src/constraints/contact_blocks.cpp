// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Greedy colouring with a set of 64 colours a body (as in Box2D 3), in as many rounds as the busiest body needs. So a
// dense cluster never falls back to a serial rest. Contacts with bodies that cannot be pushed come last in every pass,
// so that no other contact undoes what the ground did. They conflict on one body only.

#include "constraints/contact_blocks.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/compiler.h"
#include "base/gather_parts.h"
#include "geometry/outline.h"
#include "scree/settings.h"
#include "state/frames.h"

namespace scree {

namespace {

constexpr int leastContactsToShare = 512;
constexpr int kindCount = 2;       ///< of points within a colour
constexpr size_t blocksAhead = 4;  ///< that filling looks

static_assert(sizeof(Manifold) == manifoldFloats * sizeof(float));
static_assert(sizeof(SteadyContact) == steadyFloats * sizeof(float));
static_assert(offsetof(Manifold, localNormal) == manifoldNormalAt * sizeof(float));
static_assert(sizeof(ManifoldPoint) == manifoldPointFloats * sizeof(float));

/// Makes the column this long; what it held is of no interest, so that it need not be kept while there is a larger one.
template <typename Vector>
void Renew(Vector& column, size_t size) {
    if (size > column.capacity()) {
        Vector().swap(column);
        column.reserve(size + size / 16);
    }
    column.resize(size);
}

FillSource SourceOf(const BlockInput& input) {
    return {&input.bodies.transform.data()->p.x,
            &input.bodies.position.data()->c.x,
            &input.bodies.velocity.data()->v.x,
            &input.bodies.mass.data()->invMass,
            &input.contacts.manifold.data()->points[0].localPoint.x,
            &input.contacts.material.data()->friction,
            input.impulseScale,
            input.atOutlines ? 0.0f : linearSlop * input.lengthScale,
            input.restitution,
            input.onMoverSurface,
            input.steady != nullptr ? &input.steady->data()->turnA : nullptr,
            linearSlop * input.lengthScale};
}

/// Where the bodies of a block are, far from the origin.
void PlaceLanes(const BodyTable& bodies, const ContactBlock& block, FillLanes& lanes) {
    const auto place = [&bodies](Vec2 frame, BodyIndex body, float(&transform)[4], float(&position)[4]) {
        const Transform xf = TransformIn(frame, bodies, body);
        transform[0] = xf.p.x, transform[1] = xf.p.y, transform[2] = xf.q.s, transform[3] = xf.q.c;
        const Vec2 centre = CentreIn(frame, bodies, body);
        position[0] = centre.x, position[1] = centre.y;
        position[2] = bodies.position[body].a;
    };
    for (int l = 0; l < blockLanes; ++l) {
        const BodyIndex a{block.bodyA[l]}, b{block.bodyB[l]};
        const Vec2 frame = FrameOf(bodies, a, b);
        place(frame, a, lanes.transformA[l], lanes.positionA[l]);
        place(frame, b, lanes.transformB[l], lanes.positionB[l]);
    }
}

/// Where threads share colours, contacts of neighbouring bodies stand together in each of them. So a thread meets much
/// the same bodies in all colours, and what it knows of these stays in its cache. No result depends on that order.
class BodyStrips {
public:
    static constexpr size_t most = 32;

    /// `groups`: counts that are kept of each strip; 0 without contacts.
    BodyStrips(const BlockInput& input, size_t groups) {
        constexpr size_t mostCounts = 1 << 14;
        const std::span<const BodyIndex> bodies = input.bodies.Listed();
        if (!input.pool.IsOpen() || bodies.empty() || groups == 0) return;
        m_count = std::clamp(mostCounts / groups, size_t{1}, most);
        m_first = ToInt(bodies.front());  // lists are more or less in order
        const int last = ToInt(bodies.back());
        while ((last - m_first) >> m_shift >= static_cast<int>(m_count)) ++m_shift;
    }
    [[nodiscard]] size_t Count() const { return m_count; }
    [[nodiscard]] size_t Of(BodyIndex body) const {
        return ToSize(std::clamp((ToInt(body) - m_first) >> m_shift, 0, static_cast<int>(m_count) - 1));
    }

private:
    size_t m_count = 1;
    int m_first = 0, m_shift = 0;
};

}  // namespace

/// The only place that knows which side of a contact is which side of its block.
SCREE_INLINE ContactBlocks::SidedContact ContactBlocks::SortSides(const BlockInput& input, ContactIndex contact) {
    const ContactPair& pair = input.contacts.pair[contact];
    const Manifold& manifold = input.contacts.manifold[contact];
    const bool movesA = input.bodies.type[pair.bodyA] == dynamicBody;
    const bool movesB = input.bodies.type[pair.bodyB] == dynamicBody;
    const auto radiusOf = [&](FixtureIndex fixture) {
        const Shape& shape = *input.fixtures.shape[fixture];
        return input.atOutlines ? OutlineRadius(shape, input.lengthScale) : shape.m_radius;
    };
    const float radiusA = radiusOf(pair.fixtureA), radiusB = radiusOf(pair.fixtureB);
    const bool isSwapped = !movesB, isReferenceB = manifold.type == Manifold::e_faceB;
    return {.contact = contact,
            .a = isSwapped ? pair.bodyB : pair.bodyA,
            .b = isSwapped ? pair.bodyA : pair.bodyB,
            .radiusA = isSwapped ? radiusB : radiusA,
            .radiusB = isSwapped ? radiusA : radiusB,
            .isReferenceB = isReferenceB != isSwapped,
            .isCircles = manifold.type == Manifold::e_circles,
            .hasTwoPoints = manifold.pointCount == 2,
            .isFixedA = !movesA || !movesB,
            .isSwapped = isSwapped};
}

void ContactBlocks::Sort(const BlockInput& input) {
    constexpr int fetchAhead = 8;
    const size_t count = input.list.size();
    Renew(m_sided, count);
    Renew(m_colours, count);
    Renew(m_lane, count);
    const auto sort = [&](int begin, int end, const std::array<int*, 2>& places) {
        int *mover = places[0], *fixed = places[1];
        for (int i = begin; i < end; ++i) {
            if (i + fetchAhead < end) {  // rows of neighbours in the list are anywhere
                const ContactIndex ahead = input.list[ToSize(i + fetchAhead)];
                Prefetch(&input.contacts.pair[ahead]);
                Prefetch(&input.contacts.manifold[ahead].localNormal);
            }
            m_sided[ToSize(i)] = SortSides(input, input.list[ToSize(i)]);
            *mover = *fixed = i;
            (m_sided[ToSize(i)].isFixedA ? fixed : mover) += 1;
        }
        return std::array{static_cast<size_t>(mover - places[0]), static_cast<size_t>(fixed - places[1])};
    };
    GatherParts<int, 2>(input.pool, static_cast<int>(count), leastContactsToShare, {&m_movers, &m_fixed}, sort);
}

/// Deals the contacts to slices, and finds those between two.
void ContactBlocks::Slice(const BlockInput& input) {
    const auto sliceOf = [&](BodyIndex body) { return m_slices.Of(input.bodies, body); };
    const auto slice = [&](int begin, int end, const std::array<int*, 1>& places) {
        int* cut = places[0];
        for (int i = begin; i < end; ++i) {
            SidedContact& contact = m_sided[ToSize(i)];
            contact.slice = sliceOf(contact.b);
            *cut = i;
            if (contact.isFixedA) {
                const bool moves = input.bodiesFollow && input.bodies.type[contact.a] == kinematicBody;
                contact.meetsMotion = moves && sliceOf(contact.a) != contact.slice;
                continue;
            }
            cut += sliceOf(contact.a) != contact.slice ? 1 : 0;
        }
        return std::array{static_cast<size_t>(cut - places[0])};
    };
    GatherParts<int, 1>(input.pool, static_cast<int>(m_sided.size()), leastContactsToShare, {&m_cut}, slice);
}

void ContactBlocks::ColourMovers(Column<BodyIndex, uint64_t>& taken) {
    int base = 0;
    while (!m_movers.empty()) {
        for (const int i : m_movers) {
            const SidedContact& contact = At(i);
            taken[contact.a] = taken[contact.b] = 0;
        }
        m_next.clear();
        int highest = -1;
        for (const int i : m_movers) {
            const SidedContact& contact = At(i);
            uint64_t& takenA = taken[contact.a];
            uint64_t& takenB = taken[contact.b];
            const uint64_t free = ~(takenA | takenB);
            if (free == 0) {
                m_next.push_back(i);
                continue;
            }
            const int colour = std::countr_zero(free);
            takenA |= uint64_t{1} << colour;
            takenB |= uint64_t{1} << colour;
            m_colours[ToSize(i)] = base + colour;
            highest = colour > highest ? colour : highest;
        }
        base += highest + 1;
        m_movers.swap(m_next);
    }
    m_colourCount = m_moverColourCount = base;
}

void ContactBlocks::ColourFixed(Column<BodyIndex, uint64_t>& taken) {
    // The k-th contact of a body with the unmovable has the k-th colour.
    for (const int i : m_fixed) taken[At(i).b] = 0;
    int most = 0;
    for (const int i : m_fixed) {
        const int colour = static_cast<int>(taken[At(i).b]++);
        m_colours[ToSize(i)] = m_colourCount + colour;
        most = colour + 1 > most ? colour + 1 : most;
    }
    m_colourCount += most;
}

void ContactBlocks::MakeRanges(const BlockInput& input, int chains, Column<BodyIndex, uint8_t>& isAtBorder) {
    // Counting sort by (colour, points, strip) into blocks, a count for each part of the list. Of each chain there are
    // two strips: its border and the rest.
    const Parts parts(input.pool, static_cast<int>(m_sided.size()), leastContactsToShare);
    const size_t groupCount = ToSize(m_colourCount * kindCount);
    const BodyStrips strips(input, groupCount * ToSize(parts.Count()));
    // Of a chain in a colour: else threads would mostly wait.
    constexpr int leastBlocks = 16, leastWithBodies = 8, leastOfTests = 1;
    const int leastThere = input.bodiesFollow ? leastWithBodies : leastBlocks;
    const int least = input.pool.SharesAlways() ? leastOfTests : leastThere;
    const bool hasChains =
        chains > 1 && static_cast<int>(m_sided.size()) >= blockLanes * least * chains * m_colourCount;
    const size_t stripCount = hasChains ? 2 * ToSize(chains) : strips.Count();
    const auto isBorder = [&](const SidedContact& contact) {
        const bool isPushedThere = isAtBorder[contact.b] != 0 || (!contact.isFixedA && isAtBorder[contact.a] != 0);
        return isPushedThere || contact.meetsMotion;
    };
    const auto startOf = [&](int part, size_t i) -> int& {
        const SidedContact& contact = m_sided[i];
        const size_t group = ToSize(m_colours[i] * kindCount + (contact.hasTwoPoints ? 1 : 0));
        const size_t strip = hasChains ? 2 * size_t{contact.slice} + (isBorder(contact) ? 0 : 1) : strips.Of(contact.b);
        return m_start[(ToSize(part) * groupCount + group) * stripCount + strip];
    };
    m_start.assign(groupCount * stripCount * ToSize(parts.Count()), 0);
    parts.For(input.pool, [&](int part, int begin, int end) {
        for (size_t i = ToSize(begin); i < ToSize(end); ++i) ++startOf(part, i);
    });
    m_ranges.clear();
    m_chains.Clear();
    m_sections.clear();
    std::array<int, BodySlices::most> sizes{};
    const auto blocksOf = [](int lanes) { return (lanes + blockLanes - 1) / blockLanes; };
    int block = 0;
    m_blockCount = 0;
    for (size_t g = 0; g < groupCount; ++g) {
        const int first = block;
        int lanes = 0, count = 0;  // lanes from `block` on; contacts
        for (size_t strip = 0; strip < stripCount; ++strip) {
            const bool endsChain = hasChains && strip % 2 == 1;
            const int border = blocksOf(lanes);
            for (int part = 0; part < parts.Count(); ++part) {
                int& start = m_start[(ToSize(part) * groupCount + g) * stripCount + strip];
                count += start;
                if (hasChains) sizes[strip / 2] += start;
                lanes += std::exchange(start, block * blockLanes + lanes);
            }
            if (!endsChain) continue;
            m_sections.push_back({block, block + border, block + blocksOf(lanes)});
            block += blocksOf(std::exchange(lanes, 0));
        }
        block += blocksOf(lanes);
        m_blockCount += blocksOf(count);
        const bool fixedA = static_cast<int>(g / kindCount) >= m_moverColourCount;
        if (count > 0) {
            const auto colour = static_cast<int32_t>(g / kindCount);
            m_ranges.push_back({first, block, {fixedA, g % kindCount == 1}, colour});
        } else if (hasChains) {
            m_sections.resize(m_sections.size() - ToSize(chains));
        }
    }
    if (hasChains) {
        m_chains.Build(chains, m_sections, m_ranges);
        int atBorder = 0;
        for (const BlockChains::Section& section : m_sections) atBorder += section.border - section.begin;
        m_slices.Note(std::span(sizes).first(ToSize(chains)), blockLanes * atBorder);
    } else if (chains > 1) {
        m_slices.NoteUnused();
    }
    Renew(m_blocks, ToSize(block));
    const size_t lanes = (m_blocks.size() + blocksAhead) * blockLanes;
    m_order.assign(lanes, -1);
    m_contact.assign(lanes, ContactIndex{0});
    parts.For(input.pool, [&](int part, int begin, int end) {
        for (size_t i = ToSize(begin); i < ToSize(end); ++i) {
            m_lane[i] = startOf(part, i)++;
            m_order[ToSize(m_lane[i])] = static_cast<int>(i);
            m_contact[ToSize(m_lane[i])] = m_sided[i].contact;
        }
    });
}

void ContactBlocks::FetchAhead(const BlockInput& input, size_t block, size_t end) const {
    // Contacts of a colour are far apart: ask for their rows here four blocks ahead, for those of the tables two ahead,
    // and for the bodies of the next block. Rows of blocks from `end` on are not read: another worker may write them.
    const auto contactAt = [&](size_t lane) { return &At(std::max(m_order[lane], 0)); };
    for (size_t l = block * blockLanes; l < (block + 1) * blockLanes; ++l) {
        Prefetch(contactAt(l + blocksAhead * blockLanes));
        const ContactIndex far = m_contact[l + 2 * blockLanes];
        Prefetch(&input.contacts.manifold[far]);
        Prefetch(&input.contacts.material[far]);
        if (input.steady != nullptr) Prefetch(&(*input.steady)[far]);
        if (block + 1 == end || m_order[l + blockLanes] < 0) continue;
        const SidedContact* next = contactAt(l + blockLanes);
        for (const BodyIndex body : {next->a, next->b}) {
            Prefetch(&input.bodies.transform[body]);
            Prefetch(&input.bodies.position[body]);
            Prefetch(&input.bodies.velocity[body]);
            Prefetch(&input.bodies.mass[body]);
        }
    }
}

bool ContactBlocks::AreKept(const BlockInput& input, size_t k) const {
    const int* const order = &m_order[k * blockLanes];
    for (int l = 0; l < blockLanes && order[l] >= 0; ++l) {
        if ((*input.steady)[m_contact[k * blockLanes + ToSize(l)]].isKept <= 0.0f) return false;
    }
    return true;
}

/// All that filling needs of contacts that are kept; their block knows the rest from the time when it was laid out.
void ContactBlocks::NameContacts(size_t k, FillLanes& lanes) const {
    lanes.count = 0;
    for (int l = 0; l < blockLanes; ++l) {
        const bool isUsed = m_blocks[k].slot[l] >= 0;
        lanes.contact[l] = isUsed ? ToInt(m_contact[k * blockLanes + ToSize(l)]) : lanes.contact[0];
        if (isUsed) ++lanes.count;
    }
}

void ContactBlocks::NameLanes(const BlockInput& input, size_t k, FillLanes& lanes) {
    ContactBlock& block = m_blocks[k];
    lanes.count = 0;
    lanes.anyCircles = false;
    for (int l = 0; l < blockLanes; ++l) {
        const int i = m_order[k * blockLanes + ToSize(l)];
        block.slot[l] = i;
        if (i < 0) {
            // Lanes to spare come last and repeat the first.
            lanes.contact[l] = lanes.contact[0];
            block.bodyA[l] = block.bodyA[0], block.bodyB[l] = block.bodyB[0];
            for (FillLanes::Row* row :
                 {&lanes.referenceIsB, &lanes.isCircles, &lanes.isSwapped, &lanes.radiusA, &lanes.radiusB})
                (*row)[l] = (*row)[0];
            continue;
        }
        if (!m_isFresh) m_sided[ToSize(i)] = SortSides(input, At(i).contact);  // its manifold may be another
        const SidedContact& contact = At(i);
        ++lanes.count;
        lanes.contact[l] = ToInt(contact.contact);
        block.bodyA[l] = ToInt(contact.a), block.bodyB[l] = ToInt(contact.b);
        lanes.referenceIsB[l] = contact.isReferenceB ? 1.0f : 0.0f;
        lanes.isCircles[l] = contact.isCircles ? 1.0f : 0.0f;
        lanes.isSwapped[l] = contact.isSwapped ? 1.0f : 0.0f;
        lanes.anyCircles |= contact.isCircles;
        lanes.radiusA[l] = contact.radiusA;
        lanes.radiusB[l] = contact.radiusB;
    }
}

FillFindings& operator|=(FillFindings& all, FillFindings more) {
    all.bounces |= more.bounces, all.initialOverlaps += more.initialOverlaps;
    return all;
}

/// Fills blocks [begin, end).
FillFindings ContactBlocks::FillRange(const BlockInput& input, size_t begin, size_t end) {
    FillFindings found;
    if (begin == end) return found;  // there may be no contact at all, and no table to point to
    FillLanes lanes{};
    const FillSource source = SourceOf(input);
    auto range = std::upper_bound(m_ranges.begin(), m_ranges.end(), static_cast<int32_t>(begin),
                                  [](int32_t block, const BlockRange& r) { return block < r.end; });
    for (size_t k = begin; k < end; ++k) {
        if (static_cast<int32_t>(k) == range->end) ++range;
        FetchAhead(input, k, end);
        lanes.isFar = input.bodies.IsFar();
        lanes.areKept = range->kind.twoPoints && input.steady != nullptr && AreKept(input, k);
        lanes.areKept && !m_isFresh ? NameContacts(k, lanes) : NameLanes(input, k, lanes);
        if (lanes.isFar) PlaceLanes(input.bodies, m_blocks[k], lanes);
        found |= input.kernels.fill(source, lanes, range->kind, m_blocks[k]);
    }
    return found;
}

void ContactBlocks::Fill(const BlockInput& input) {
    constexpr int leastBlocksToFill = 16;
    FillFindings found[maxWorkers];
    For(input.pool, leastBlocksToFill,
        [&](int begin, int end, int worker) { found[worker] |= FillRange(input, ToSize(begin), ToSize(end)); });
    m_findings = {};
    for (const FillFindings& one : found) m_findings |= one;
}

bool ContactBlocks::IsLaidOut(const BlockInput& input) const {
    if (m_grouping != input.contacts.grouping || m_sided.size() != input.list.size()) return false;
    if (m_slices.Count() > 1 && m_slices.GetEdition() != m_edition) return false;
    return AllOf(input.pool, static_cast<int>(m_sided.size()), leastContactsToShare, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            if (At(i).contact != input.list[ToSize(i)]) return false;
        }
        return true;
    });
}

/// Steps that threads share follow on steps that one thread does alone, and are not to allocate for that.
void ContactBlocks::ReserveForThreads(size_t chains) {
    const size_t groups = ToSize(m_colourCount * kindCount), count = m_sided.size();
    const size_t blocks = count / blockLanes + groups * (chains + 1) + blocksAhead;
    ReserveRows(groups * std::max(2 * chains, BodyStrips::most), m_start);
    ReserveRows(groups * chains, m_sections);
    ReserveRows(groups, m_ranges);
    ReserveRows(count, m_cut);
    ReserveRows(blocks * blockLanes, m_order, m_contact);
    m_chains.Reserve(chains, groups);
    if (m_blocks.capacity() < blocks) {
        m_blocks.clear();
        m_blocks.reserve(blocks + blocks / 16);
    }
}

void ContactBlocks::LayOut(const BlockInput& input, BodyMarks& marks) {
    const size_t rows = ToSize(input.bodies.slots.Size());
    marks.coloursTaken.resize(rows);
    const bool mayShare = input.pool.GetWorkerCount() > 1;
    if (mayShare) EnsureRows(marks.isAtBorder, rows);
    const int chains = m_slices.Count();
    Sort(input);
    ColourMovers(marks.coloursTaken);
    ColourFixed(marks.coloursTaken);
    m_cut.clear();
    if (chains > 1) Slice(input);
    const auto mark = [&](uint8_t isAtBorder) {
        for (const int i : m_cut) marks.isAtBorder[At(i).a] = marks.isAtBorder[At(i).b] = isAtBorder;
    };
    mark(1);
    if (mayShare) ReserveForThreads(ToSize(std::min(input.pool.GetWorkerCount(), BodySlices::most)));
    MakeRanges(input, chains, marks.isAtBorder);
    mark(0);
    m_grouping = input.contacts.grouping;
    m_edition = m_slices.GetEdition();
}

void ContactBlocks::Build(const BlockInput& input, BodyMarks& marks) {
    m_isFresh = !IsLaidOut(input);
    if (m_isFresh) LayOut(input, marks);
    Fill(input);
}

void ContactBlocks::Store(float scale, TaskPool& pool, Column<ContactIndex, Manifold>& manifold) const {
    constexpr int leastBlocksToStore = 64;
    For(pool, leastBlocksToStore,
        [&](int begin, int end, int /*worker*/) { StoreRange(ToSize(begin), ToSize(end), scale, manifold); });
}

void ContactBlocks::StoreRange(size_t begin, size_t end, float scale, Column<ContactIndex, Manifold>& manifold) const {
    for (size_t k = begin; k < end; ++k) {
        const ContactBlock& block = m_blocks[k];
        const ContactIndex* contact = &m_contact[k * blockLanes];
        for (int l = 0; l < blockLanes; ++l) {
            Prefetch(&manifold[contact[l + 2 * blockLanes]]);
            if (block.slot[l] < 0) continue;
            Manifold& m = manifold[contact[l]];
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
    impulses.resize(m_sided.size());
    for (size_t i = 0; i < m_sided.size(); ++i) {
        const ContactBlock& block = m_blocks[ToSize(m_lane[i] / blockLanes)];
        const int l = m_lane[i] % blockLanes;
        ContactImpulse& out = impulses[i];
        out.count = m_sided[i].hasTwoPoints ? 2 : 1;
        const float tangent = (summed ? block.totalTangent : block.tangentImpulse)[l] / static_cast<float>(out.count);
        for (int p = 0; p < out.count; ++p) {
            out.normalImpulses[p] = (summed ? block.totalNormal : block.normalImpulse)[p][l];
            out.tangentImpulses[p] = tangent;
        }
    }
}

void ContactBlocks::LeaveJointed(const BodyTable& bodies, TaskPool& pool, Column<ContactIndex, SteadyContact>& steady) {
    ForEachLane(pool, [&](ContactIndex contact, size_t k, size_t l) {
        ContactBlock& block = m_blocks[k];
        if (block.initialOverlap[0][l] == 0.0f && block.initialOverlap[1][l] == 0.0f) return;
        const BodyIndex a{block.bodyA[l]}, b{block.bodyB[l]};
        if (bodies.info[a].jointCount == 0 && bodies.info[b].jointCount == 0) return;
        for (int p = 0; p < 2; ++p) {
            block.separation[p][l] -= block.initialOverlap[p][l];
            block.initialOverlap[p][l] = 0.0f;
        }
        steady[contact].initialOverlap = 0.0f;
    });
}

void ContactBlocks::StoreInitialOverlaps(TaskPool& pool, Column<ContactIndex, SteadyContact>& steady) const {
    ForEachLane(pool, [&](ContactIndex contact, size_t k, size_t l) {
        const ContactBlock& block = m_blocks[k];
        steady[contact].initialOverlap = Max(block.initialOverlap[0][l], block.initialOverlap[1][l]);
    });
}

float ContactBlocks::GetSeparation(size_t at, const Column<BodyIndex, Velocity>& delta) const {
    const ContactBlock& block = m_blocks[ToSize(m_lane[at] / blockLanes)];
    const int l = m_lane[at] % blockLanes;
    const Velocity& a = delta[BodyIndex{block.bodyA[l]}];
    const Velocity& b = delta[BodyIndex{block.bodyB[l]}];
    const float closer = Dot({block.normalX[l], block.normalY[l]}, b.v - a.v);
    float least = std::numeric_limits<float>::max();
    for (int p = 0; p < (m_sided[at].hasTwoPoints ? 2 : 1); ++p) {
        least = Min(least, block.separation[p][l] + closer + (block.armB[p][l] * b.w - block.armA[p][l] * a.w));
    }
    return least;
}

KernelTask ContactBlocks::Task(Column<BodyIndex, Velocity>& velocity, Column<BodyIndex, Velocity>& delta) {
    static_assert(sizeof(Velocity) == 4 * sizeof(float));
    return {.blocks = m_blocks.data(),
            .ranges = m_ranges.data(),
            .rangeCount = static_cast<int32_t>(m_ranges.size()),
            .chains = m_chains.IsEmpty() ? nullptr : &m_chains,
            .velocity = &velocity.data()->v.x,
            .delta = &delta.data()->v.x,
            .soft = {},
            .sumImpulses = false,
            .friction = true};
}

}  // namespace scree
