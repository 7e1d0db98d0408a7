// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Many contacts as blocks of eight for the vector kernels. Colours them so that no two contacts of a colour push the
// same body, fills the blocks, and takes the impulses back out.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/leave_raw.h"
#include "base/task_pool.h"
#include "constraints/block_chains.h"
#include "constraints/body_slices.h"
#include "constraints/contact_block.h"
#include "scree/collision.h"
#include "scree/settings.h"
#include "scree/world_callbacks.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

struct BlockInput {
    TaskPool& pool;
    const BodyTable& bodies;
    const FixtureTable& fixtures;
    const ContactTable& contacts;
    std::span<const ContactIndex> list;  ///< contacts, in order; every one has a mover
    float impulseScale;                  ///< of warm starting: the kernels' step / last dt, 0 without
    bool restitution = true;             ///< some contact may bounce
    float lengthScale = 1.0f;            ///< factor on slop and skins
    /// Bodies rest where their outlines touch, and skins only tell how far ahead contacts are known; else skins rest
    /// in each other by the slop.
    bool atOutlines = false;
    Column<ContactIndex, SteadyContact>* steady = nullptr;  ///< kept geometry, or none
    /// Friction with the unmovable acts on the mover's own surface, so that disks roll by their radius, instead of
    /// halfway between both surfaces.
    bool onMoverSurface = false;
    /// Passes end with the bodies of each slice (BlockChains). So chains spare more ends of loops, and shorter ones
    /// pay.
    bool bodiesFollow = false;
    const ContactKernels& kernels = GetContactKernels();
};

/// Scratch of colouring, by body of the world. Blocks that are built at once need their own; each of many need not,
/// which would be as many rows as bodies times blocks.
struct BodyMarks {
    Column<BodyIndex, uint64_t> coloursTaken;  ///< in a round
    Column<BodyIndex, uint8_t> isAtBorder;     ///< contacts of several chains push it; 0 between layouts

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(coloursTaken, isAtBorder); }
};

/// Blocks, kept between steps.
class ContactBlocks {
public:
    /// How threads share the blocks; of the step, before Build.
    [[nodiscard]] BodySlices& GetSlices() { return m_slices; }
    /// Colours and fills; colours are kept while the list and its grouping are the same. O(contacts); with more than 64
    /// contacts on one body in rounds of 64 colours.
    void Build(const BlockInput& input, BodyMarks& marks);
    /// Writes the impulses into the manifolds, times `scale`.
    void Store(float scale, TaskPool& pool, Column<ContactIndex, Manifold>& manifold) const;
    /// Impulses summed over the step (soft step) or accumulated, by position in the list; for reports.
    void GetImpulses(bool summed, std::vector<ContactImpulse>& impulses) const;

    /// Sum of a contact's normal impulses, by position in the list.
    [[nodiscard]] float GetPressure(int at) const {
        const int lane = m_lane[ToSize(at)];
        const ContactBlock& block = m_blocks[ToSize(lane / blockLanes)];
        return block.normalImpulse[0][lane % blockLanes] + block.normalImpulse[1][lane % blockLanes];
    }
    /// The smallest separation of a contact, by position in the list, when bodies have moved by `delta`; + the slop, m.
    [[nodiscard]] float GetSeparation(size_t at, const Column<BodyIndex, Velocity>& delta) const;

    [[nodiscard]] KernelTask Task(Column<BodyIndex, Velocity>& velocity, Column<BodyIndex, Velocity>& delta);
    [[nodiscard]] bool IsEmpty() const { return m_ranges.empty(); }
    /// Whether each chain is what pushes the bodies of a slice, as those were sorted in this step, but for the borders
    /// of other chains.
    [[nodiscard]] bool FollowSlices() const {
        return !m_chains.IsEmpty() && m_chains.Count() == m_slices.Count() && (m_isFresh || m_slices.AreByNumber());
    }
    /// How many blocks one thread alone would have; several may have some more.
    [[nodiscard]] int GetBlockCount() const { return m_blockCount; }
    [[nodiscard]] bool Bounces() const { return m_findings.bounces; }
    /// Contacts with initial overlap (SteadyContact).
    [[nodiscard]] int GetInitialOverlapCount() const { return m_findings.initialOverlaps; }
    /// That of bodies with joints is left to springs: moving them would tear their joints.
    void LeaveJointed(const BodyTable& bodies, TaskPool& pool, Column<ContactIndex, SteadyContact>& steady);
    /// Writes what is left of the overlaps that contacts began with.
    void StoreInitialOverlaps(TaskPool& pool, Column<ContactIndex, SteadyContact>& steady) const;
    [[nodiscard]] int GetColourCount() const { return m_colourCount; }
    /// Colour of each contact of the list.
    [[nodiscard]] std::span<const int> GetColours() const { return m_colours; }
    /// Contacts for which there is room.
    [[nodiscard]] size_t GetRoom() const { return m_sided.capacity(); }
    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(m_blocks, m_ranges, m_sided, m_colours, m_movers, m_fixed, m_next, m_start, m_lane, m_order,
                       m_contact, m_cut, m_sections) +
               m_chains.GetMemoryBytes();
    }
    /// For blocks that one worker solves, without chains.
    void MatchRoomOf(const ContactBlocks& other) {
        MatchRoom(m_blocks, other.m_blocks), MatchRoom(m_ranges, other.m_ranges), MatchRoom(m_sided, other.m_sided);
        MatchRoom(m_colours, other.m_colours), MatchRoom(m_movers, other.m_movers), MatchRoom(m_fixed, other.m_fixed);
        MatchRoom(m_next, other.m_next), MatchRoom(m_start, other.m_start), MatchRoom(m_lane, other.m_lane);
        MatchRoom(m_order, other.m_order), MatchRoom(m_contact, other.m_contact);
    }

private:
    /// A contact of the list as its block sees it: side B can be pushed. Colouring and naming read these rows instead
    /// of the tables, and know nothing of the contact's own sides.
    struct SidedContact {
        ContactIndex contact;
        BodyIndex a, b;          ///< bodies
        float radiusA, radiusB;  ///< of their shapes, m
        bool isReferenceB : 1;   ///< the manifold's face is B's
        bool isCircles : 1, hasTwoPoints : 1;
        bool isFixedA : 1;             ///< side A cannot be pushed
        bool isSwapped : 1;            ///< side A is the contact's B
        bool meetsMotion : 1 = false;  ///< where bodies follow: side A moves by itself, in another slice
        uint8_t slice = 0;             ///< that of side B
    };
    static_assert(sizeof(SidedContact) == 24, "worlds have a hundred thousand of them, read three times a step");

    static SidedContact SortSides(const BlockInput& input, ContactIndex contact);

    [[nodiscard]] bool IsLaidOut(const BlockInput& input) const;
    void LayOut(const BlockInput& input, BodyMarks& marks);
    void Sort(const BlockInput& input);
    void Slice(const BlockInput& input);
    void ColourMovers(Column<BodyIndex, uint64_t>& taken);
    void ColourFixed(Column<BodyIndex, uint64_t>& taken);
    void MakeRanges(const BlockInput& input, int chains, Column<BodyIndex, uint8_t>& isAtBorder);
    void ReserveForThreads(size_t chains);
    void Fill(const BlockInput& input);
    [[nodiscard]] bool AreKept(const BlockInput& input, size_t block) const;
    void NameContacts(size_t block, FillLanes& lanes) const;
    void NameLanes(const BlockInput& input, size_t block, FillLanes& lanes);
    void StoreRange(size_t begin, size_t end, float scale, Column<ContactIndex, Manifold>& manifold) const;
    FillFindings FillRange(const BlockInput& input, size_t begin, size_t end);
    void FetchAhead(const BlockInput& input, size_t block, size_t end) const;
    /// Calls visit(contact, block, lane) for all contacts, block by block: those of the list are anywhere in them.
    template <typename Visit>
    void ForEachLane(TaskPool& pool, Visit&& visit) const {
        constexpr int least = 64;  // blocks that are worth sharing
        For(pool, least, [&](int begin, int end, int /*worker*/) {
            for (size_t k = ToSize(begin); k < ToSize(end); ++k) {
                for (size_t l = 0; l < blockLanes && m_blocks[k].slot[l] >= 0; ++l)
                    visit(m_contact[k * blockLanes + l], k, l);
            }
        });
    }
    /// Calls body(begin, end, worker) for all blocks, those of a chain on its thread.
    template <typename Body>
    void For(TaskPool& pool, int least, Body&& body) const {
        if (m_chains.IsEmpty() || !pool.IsOpen()) return pool.For(static_cast<int>(m_blocks.size()), least, body);
        const std::span<const BlockChains::Section> sections = m_chains.GetSections();
        pool.For(static_cast<int>(sections.size()), 2, [&](int begin, int end, int worker) {
            for (const BlockChains::Section& section : sections.subspan(ToSize(begin), ToSize(end - begin)))
                body(section.begin, section.end, worker);
        });
    }
    /// By position in the list.
    [[nodiscard]] const SidedContact& At(int i) const { return m_sided[ToSize(i)]; }

    std::vector<ContactBlock, LeaveRaw<ContactBlock>> m_blocks;
    std::vector<BlockRange> m_ranges;
    std::vector<SidedContact> m_sided;    ///< per contact of the list
    std::vector<int> m_colours;           ///< per contact of the list
    std::vector<int> m_movers, m_fixed;   ///< positions in the list; movers that have no colour yet
    std::vector<int> m_next;              ///< the same for the next round
    std::vector<int> m_cut;               ///< positions in the list of contacts between slices
    std::vector<int> m_start;             ///< per part of the list, group and strip: first lane
    std::vector<int> m_lane;              ///< per contact of the list: block · 8 + lane
    std::vector<int> m_order;             ///< per lane, and some more: position in the list, −1 to spare
    std::vector<ContactIndex> m_contact;  ///< the same: contact, 0 to spare
    uint64_t m_grouping = 0;              ///< that of the table (ContactTable::grouping) when it was laid out
    bool m_isFresh = true;                ///< laid out in the last call of Build
    BodySlices m_slices;
    BlockChains m_chains;                          ///< none where threads do not share the blocks
    std::vector<BlockChains::Section> m_sections;  ///< by group and chain
    int m_edition = 0;                             ///< of the slices when it was laid out
    int m_blockCount = 0;
    int m_moverColourCount = 0;  ///< colours below it have two movers a contact, the others one
    int m_colourCount = 0;
    FillFindings m_findings;
};

}  // namespace scree
