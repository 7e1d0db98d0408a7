// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A base is an image of the whole world and a copy of what moves: the columns that a step writes. A moment is the
// difference of these columns to its base. Definitions follow a stamp (DefinitionStamp): while the world has that of
// the base, only what moves is put back. If not, the image of the base goes first.

#include "scree/rollback.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "base/byte_difference.h"
#include "base/bytes.h"
#include "pipeline/parts/update_boxes.h"
#include "world/guard.h"
#include "world/state_fields.h"

namespace scree {

namespace {

/// What moves beside columns.
struct LooseState {
    bool isEdited = false, mustMatch = false, autoClearForces = true, keepsSteady = false, resuming = false;
    float lastInverseDt = 0.0f;
    FeatureCounts featureCounts;
};

/// Visits the columns in a list of fields, and nothing else.
template <typename Visit>
class ColumnsOnly {
public:
    explicit ColumnsOnly(Visit& visit) : m_visit(visit) {}
    template <typename... T>
    void operator()(T&... values) {
        (One(values), ...);
    }
    template <typename Table, typename... T>
    void Rows(const Table&, T&... columns) {
        (m_visit(columns), ...);
    }
    template <typename... T>
    void LeftOut(const T&...) {}

private:
    template <typename T>
    void One(T& value) {
        if constexpr (AnyColumn<T>) m_visit(value);
    }
    Visit& m_visit;
};

/// What distinguishes the stored box from that of the present pose: 0 unless the body fell asleep or was moved since.
using BoxBits = std::array<uint64_t, 2>;
static_assert(sizeof(BoxBits) == sizeof(AABB));

/// Visits every column that a step writes. `boxes` is what GatherBoxes gives.
template <typename Visit>
void VisitMotion(WorldState& s, Column<FixtureIndex, BoxBits>& boxes, Visit visit) {
    const auto each = [&](auto&... columns) { (visit(columns), ...); };
    BodyTable::MotionFields(s.bodies, each);
    ColumnsOnly only(visit);
    ContactTable::Fields(s.contacts, only);
    std::apply([&](auto&... store) { (visit(store.rows), ...); }, s.joints.stores);
    each(s.continuousScratch.alpha, s.continuousScratch.ballistic);
    visit(boxes);
}

template <AnyColumn T>
std::span<std::byte> BytesIn(T& column) {
    static_assert(std::is_trivially_copyable_v<typename T::value_type>);
    return {reinterpret_cast<std::byte*>(column.data()), column.size() * sizeof(column.front())};
}

template <typename Visit>
void ForEachProxy(const WorldState& s, Visit visit) {
    for (const FixtureIndex fixture : s.fixtures.slots.Rows()) {
        if (s.fixtures.slots.IsAlive(fixture) && s.fixtures.info[fixture].inBroadPhase) visit(fixture);
    }
}

/// Where the bodies stand in the step is of no meaning unless it goes on.
void ForgetWays(ToiScratch& scratch) {
    for (const BodyIndex body : scratch.touched) {
        if (scratch.alpha.Has(body)) scratch.alpha[body] = 0.0f;
    }
    scratch.ballistic.clear();
}

/// From boxes to what distinguishes them, and back.
BoxBits Distinguish(const WorldState& s, FixtureIndex fixture, const BoxBits& box) {
    const auto present = std::bit_cast<BoxBits>(FindBox(s.bodies, s.fixtures, fixture));
    return {box[0] ^ present[0], box[1] ^ present[1]};
}

void GatherBoxes(const WorldState& s, Column<FixtureIndex, BoxBits>& boxes) {
    boxes.assign(ToSize(s.fixtures.slots.Size()), BoxBits{});
    ForEachProxy(s, [&](FixtureIndex fixture) {
        boxes[fixture] = Distinguish(s, fixture, std::bit_cast<BoxBits>(s.broadPhase->GetBox(ProxyOf(fixture))));
    });
}

/// Gives the broad phase the boxes that are other ones.
void PutBoxes(WorldState& s, const Column<FixtureIndex, BoxBits>& boxes) {
    bool areStaticsElsewhere = false;
    ForEachProxy(s, [&](FixtureIndex fixture) {
        const BoxBits box = Distinguish(s, fixture, boxes[fixture]);
        if (box == std::bit_cast<BoxBits>(s.broadPhase->GetBox(ProxyOf(fixture)))) return;
        s.broadPhase->Update(ProxyOf(fixture), std::bit_cast<AABB>(box), vec2Zero);
        areStaticsElsewhere = areStaticsElsewhere || s.bodies.type[s.fixtures.body[fixture]] == staticBody;
    });
    if (areStaticsElsewhere) s.continuousScratch.nearStatics.ForgetAll();
}

/// After the columns were put back: what is made of them.
void FollowMotion(WorldState& s, const LooseState& loose, const ContactTable::FormerRows& before) {
    s.isEdited = loose.isEdited;
    s.autoClearForces = loose.autoClearForces;
    s.contacts.keepsSteady = loose.keepsSteady;
    s.continuousScratch.resuming = loose.resuming;
    s.lastInverseDt = loose.lastInverseDt;
    s.featureCounts = loose.featureCounts;
    s.edited.Clear();
    if (s.isEdited) s.edited.AddAll();
    // What was edited, or what another filter lets collide, may sleep: the coming step looks at all.
    const bool looksAtAll = loose.isEdited || loose.mustMatch;
    for (const BodyIndex body : s.bodies.movers) {
        if (looksAtAll || s.bodies.Has(body, BodyFlag::awake)) s.bodies.List(body);
    }
    s.bodies.fellAsleep = 1;  // some that are listed may have been asleep
    s.contacts.NoteReturn(before);
    for (const BodyIndex body : s.continuousScratch.alpha.Rows()) {
        if (s.continuousScratch.alpha[body] > 0.0f) s.continuousScratch.touched.push_back(body);
    }
    s.islands.Clear();
    s.active.Clear();
    s.substepGroups.Clear();
    s.solverScratch.anglesHaveRests = true;
    s.idleSubsteps = WorldState::notIdle;
}

}  // namespace

struct Rollback::Base {
    uint64_t stamp = 0;
    std::vector<std::byte> image;
    std::vector<std::byte> columns;  ///< one behind the other
    std::vector<size_t> ends;        ///< of these
    [[nodiscard]] std::span<const std::byte> Get(size_t column) const {
        const size_t begin = column == 0 ? 0 : ends[column - 1];
        return std::span(columns).subspan(begin, ends[column] - begin);
    }
};

struct Rollback::Moment {
    int64_t number = -1;
    std::shared_ptr<const Base> base;
    LooseState loose;
    Features allowed;  ///< what the world might use then, and what it used is among that
    DifferenceWriter::Bytes differences;
    LaterEnds later;
};

struct Rollback::Kept {
    Kept(World& of, int mostMoments) : world(of), moments(ToSize(std::max(mostMoments, 1))) {}

    [[nodiscard]] Moment& PlaceOf(int64_t number) { return moments[static_cast<size_t>(number) % moments.size()]; }
    [[nodiscard]] bool NeedsBase(const WorldState& s) const {
        return base == nullptr || base->stamp != s.definitions.Get() || !s.definitions.IsKnown() ||
               s.broadPhase->UsesDisplacement();
    }
    /// What moved long ago and rests now stays in every difference: at times a new base is less work.
    void ForgetOldBase(const WorldState& s, const Moment& moment) {
        constexpr int leastSaves = 64;
        constexpr size_t bytesPerRow = 256, fewBytes = 65536;
        const size_t rows = ToSize(s.bodies.listedRows.Count() + s.contacts.active.Count() + s.joints.slots.Count());
        if (++savesOfBase >= leastSaves && moment.differences.size() > fewBytes + bytesPerRow * rows) base = nullptr;
    }
    void MakeBase(WorldState& s) {
        savesOfBase = 0;
        auto made = std::make_shared<Base>();
        made->stamp = s.definitions.Get();
        made->image = SaveWorld(world);
        VisitMotion(s, boxes, [&](auto& column) {
            const std::span<const std::byte> bytes = BytesIn(column);
            made->columns.insert(made->columns.end(), bytes.begin(), bytes.end());
            made->ends.push_back(made->columns.size());
        });
        base = std::move(made);
    }
    void PutBack(WorldState& s, const Moment& moment) {
        before.flags = s.contacts.flags;
        before.pair = s.contacts.pair;
        ForgetWays(s.continuousScratch);
        DifferenceReader differences(moment.differences);
        size_t number = 0;
        VisitMotion(s, boxes, [&](auto& column) {
            column.resize(differences.NextSize() / sizeof(column.front()));
            differences.Read(moment.base->Get(number++), BytesIn(column));
        });
        PutBoxes(s, boxes);
        FollowMotion(s, moment.loose, before);
        s.log.Restart(moment.later);
    }

    World& world;
    std::vector<Moment> moments;  ///< by number, modulo their count
    int64_t next = 0;
    int savesOfBase = 0;
    std::shared_ptr<const Base> base;     ///< of the newest moment, or null
    Column<FixtureIndex, BoxBits> boxes;  ///< scratch
    ContactTable::FormerRows before;      ///< scratch
};

Rollback::Rollback(World& world, int mostMoments) : m_kept(std::make_unique<Kept>(world, mostMoments)) {}
Rollback::~Rollback() = default;

int64_t Rollback::Save() {
    WorldState& s = m_kept->world.GetState();
    if (s.IsLocked()) {
        s.Refuse(ErrorCode::locked, "Rollback::Save", "world", "save outside of Step and callbacks");
        return -1;
    }
    if (!s.continuousScratch.resuming) ForgetWays(s.continuousScratch);
    GatherBoxes(s, m_kept->boxes);
    if (m_kept->NeedsBase(s)) m_kept->MakeBase(s);
    Moment& moment = m_kept->PlaceOf(m_kept->next);
    moment.number = -1;
    moment.base = m_kept->base;
    DifferenceWriter differences(moment.differences);
    size_t number = 0;
    VisitMotion(s, m_kept->boxes, [&](auto& column) { differences.Add(moment.base->Get(number++), BytesIn(column)); });
    moment.loose = {
        s.isEdited,      s.contacts.mustMatch, s.autoClearForces, s.contacts.keepsSteady, s.continuousScratch.resuming,
        s.lastInverseDt, s.featureCounts};
    moment.allowed = AllowedFeatures(s.def);
    moment.later = s.log.GetLater();
    m_kept->ForgetOldBase(s, moment);
    return moment.number = m_kept->next++;
}

SnapshotError Rollback::Restore(int64_t number) {
    WorldState& s = m_kept->world.GetState();
    if (!Has(number)) {
        s.Refuse(ErrorCode::outOfRange, "Rollback::Restore", "moment", "give the number of one of the newest moments");
        return SnapshotError::refused;
    }
    if (s.IsLocked() || s.recorder != nullptr) {
        s.Refuse(ErrorCode::locked, "Rollback::Restore", "world", "restore outside of Step, callbacks and recordings");
        return SnapshotError::refused;
    }
    const Moment& moment = m_kept->PlaceOf(number);
    const Features missing = moment.allowed - AllowedFeatures(s.def);
    if (!missing.IsEmpty()) {
        s.Refuse(ErrorCode::missingFeature, "Rollback::Restore", GetName(missing.First()),
                 "add it by World::SetFeatures: the world had it when the moment was saved");
        return SnapshotError::refused;
    }
    if (moment.base->stamp != s.definitions.Get() || !s.definitions.IsKnown() || s.broadPhase->UsesDisplacement()) {
        if (const SnapshotError error = RestoreWorld(m_kept->world, moment.base->image); error != SnapshotError::ok)
            return error;
        s.definitions.Return(moment.base->stamp);
    }
    m_kept->PutBack(s, moment);
    m_kept->base = moment.base;
    return SnapshotError::ok;
}

bool Rollback::Has(int64_t moment) const { return moment >= 0 && m_kept->PlaceOf(moment).number == moment; }

size_t Rollback::GetBytes(int64_t moment) const {
    if (!Has(moment)) return 0;
    const Moment& of = m_kept->PlaceOf(moment);
    return sizeof(Moment) + of.differences.size() + of.later.GetMemoryBytes();
}

size_t Rollback::GetMemoryBytes() const {
    size_t bytes = sizeof(Kept) + BytesOf(m_kept->moments, m_kept->boxes, m_kept->before.flags, m_kept->before.pair);
    std::vector<const Base*> bases;
    const auto add = [&](const Base* base) {
        if (base == nullptr || std::find(bases.begin(), bases.end(), base) != bases.end()) return;
        bases.push_back(base);
        bytes += sizeof(Base) + BytesOf(base->image, base->columns, base->ends);
    };
    add(m_kept->base.get());
    for (const Moment& moment : m_kept->moments) {
        bytes += BytesOf(moment.differences) + moment.later.GetMemoryBytes();
        add(moment.base.get());
    }
    return bytes;
}

}  // namespace scree
