// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// World → image and image → world. Layout: magic, version, size, checksum of the rest; then definition, tables, shapes,
// boxes of the broad phase, settings. What only caches the tables (the contact hash, the tree) is not stored but made
// again. The pairs of the stored boxes do not depend on how they came about, and contacts are kept in the order of
// their rows. Boxes are stored because they may be older than the poses (of a body that fell asleep) or larger
// (fat-tree).

#include "scree/snapshot.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/collide.h"
#include "world/guard.h"
#include "world/joints/joint_definitions.h"
#include "world/refresh.h"
#include "world/snapshot_check.h"
#include "world/state_fields.h"
#include "world/validate.h"

namespace scree {

namespace {

constexpr std::array<char, 8> magic = {'s', 'c', 'r', 'e', 'e', 'w', 'l', 'd'};

/// In front of every image; no padding.
struct Header {
    std::array<char, 8> name;
    uint32_t version;
    uint32_t byteOrder;  ///< snapshotByteOrder on a machine of the same order
    uint64_t size;       ///< of the whole image
    uint64_t checksum;   ///< of everything behind the header
};
static_assert(sizeof(Header) == 32);
constexpr uint32_t snapshotByteOrder = 0x01020304u, otherByteOrder = 0x04030201u;

bool ReadShape(FixtureTable& fixtures, FixtureIndex fixture, ImageReader& in) {
    bool safe = true;
    const bool known = WithShapeType(fixtures.type[fixture], [&]<typename T>(std::type_identity<T>) {
        T shape;
        in(shape);
        safe = !in.Failed() && IsSafe(shape) && !Check(shape);
        if (safe) fixtures.SetShape(fixture, shape);
    });
    return known && safe;
}

bool ReadShapesAndBoxes(WorldState& s, ImageReader& in) {
    s.fixtures.shape.assign(s.fixtures.info.size(), nullptr);
    for (const FixtureIndex fixture : s.fixtures.slots.Rows()) {
        s.fixtures.handles.emplace_back(&s, fixture);
        if (!s.fixtures.slots.IsAlive(fixture)) continue;
        if (!ReadShape(s.fixtures, fixture, in)) return false;
        if (!s.fixtures.info[fixture].inBroadPhase) continue;
        AABB box;
        in(box);
        if (in.Failed() || !IsPossible(box)) return false;
        RestoreProxy(s, fixture, box);
    }
    return true;
}

/// Puts a sub-stepped step that is not over yet back to where its bodies stand.
bool ResumeSubStep(ContinuousScratch& scratch, size_t bodyCount) {
    if (scratch.alpha.size() > bodyCount || scratch.ballistic.size() > bodyCount) return false;
    for (const BodyIndex body : scratch.alpha.Rows()) {
        if (scratch.alpha[body] < 0.0f || scratch.alpha[body] > 1.0f) return false;
        if (scratch.alpha[body] > 0.0f) scratch.touched.push_back(body);
    }
    return true;
}

/// The collision functions take two shapes in one order only, and dispatch on it.
bool CanCollide(const ContactTable& contacts, const FixtureTable& fixtures) {
    for (const ContactIndex contact : contacts.flags.Rows()) {
        if (!contacts.IsAlive(contact)) continue;
        const ContactPair& pair = contacts.pair[contact];
        const CollideEntry entry = FindCollide(fixtures.type[pair.fixtureA], fixtures.type[pair.fixtureB]);
        if (entry.function == nullptr || entry.swap) return false;
    }
    return true;
}

bool Read(WorldState& s, ImageReader& in) {
    in(s.bodies);
    if (in.Failed() || !AreBodiesConsistent(s.bodies)) return false;
    for (const BodyIndex body : s.bodies.slots.Rows()) s.bodies.handles.emplace_back(&s, body);
    s.bodies.ListAll();
    in(s.fixtures);
    if (in.Failed() || !AreFixturesConsistent(s.fixtures, s.bodies) || !ReadShapesAndBoxes(s, in)) return false;
    in(s.contacts);
    if (in.Failed() || !s.contacts.Restore() || !AreContactsConsistent(s.contacts, s.fixtures)) return false;
    if (!CanCollide(s.contacts, s.fixtures)) return false;
    in(s.joints);
    if (in.Failed() || !s.joints.Restore(&s, s.bodies.slots.Size()) || !AreJointsConsistent(s.joints, s.bodies))
        return false;
    in(s);
    if (in.Failed() || !ResumeSubStep(s.continuousScratch, s.bodies.info.size())) return false;
    RecountFeatures(s);
    if (!AllowedFeatures(s.def).Contains(UsedOf(CountFeatureUsers(s)))) return false;
    if (s.isEdited) {
        s.edited.AddAll();
    } else {
        s.broadPhase->FindPairs(s.pairs);  // as after the step before
    }
    RehangGears(s);  // which hung on static bodies, too, in images of older engines
    return !in.Failed() && in.AtEnd();
}

/// The body of an image whose header is right.
std::span<const std::byte> Open(std::span<const std::byte> image, SnapshotError& error) {
    Header header{};
    error = SnapshotError::notASnapshot;
    if (image.size() < sizeof(header)) {
        const size_t known = std::min(image.size(), magic.size());
        if (known > 0 && std::memcmp(image.data(), magic.data(), known) == 0) error = SnapshotError::wrongSize;
        return {};
    }
    std::memcpy(&header, image.data(), sizeof(header));
    if (header.name != magic) return {};
    if (header.byteOrder == otherByteOrder) error = SnapshotError::wrongByteOrder;
    if (header.byteOrder != snapshotByteOrder) return {};
    error = SnapshotError::wrongVersion;
    if (header.version != snapshotVersion) return {};
    error = SnapshotError::wrongSize;
    if (header.size != image.size()) return {};
    const std::span<const std::byte> rest = image.subspan(sizeof(header));
    error = ChecksumOf(rest) == header.checksum ? SnapshotError::ok : SnapshotError::wrongChecksum;
    return rest;
}

std::unique_ptr<World> MakeWorld(std::span<const std::byte> content) {
    ImageReader in(content);
    WorldDef def;
    in(def);
    if (in.Failed() || Check(def)) return nullptr;
    auto world = std::make_unique<World>(def);
    return Read(world->GetState(), in) ? std::move(world) : nullptr;
}

/// Rows of `fresh` get the handles that `kept` has for them.
template <typename I, typename Handle>
void TakeHandles(StableColumn<I, Handle>& fresh, StableColumn<I, Handle>& kept, int rows, WorldState& s) {
    fresh.swap(kept);
    while (ToInt(fresh.End()) < rows) fresh.emplace_back(&s, fresh.End());
}

/// The definition of an image without what it leaves out.
WorldDef WithOwnSettings(const WorldDef& own, WorldDef def) {
    def.workerCount = own.workerCount;
    def.tasks = own.tasks;
    def.featureMode = own.featureMode;
    def.features = own.features;
    return def;
}

/// Moves the state of a world into another one, which goes on as that world.
void MoveState(WorldState& from, WorldState& s) {
    s.def = WithOwnSettings(s.def, from.def);
    s.definitions.Note();
    TakeHandles(from.bodies.handles, s.bodies.handles, from.bodies.slots.Size(), s);
    TakeHandles(from.fixtures.handles, s.fixtures.handles, from.fixtures.slots.Size(), s);
    from.contacts.TakeHandles(s.contacts);
    from.joints.TakeHandles(&s, s.joints);
    s.bodies = std::move(from.bodies);
    s.fixtures = std::move(from.fixtures);
    s.contacts = std::move(from.contacts);
    s.joints = std::move(from.joints);
    s.broadPhase = std::move(from.broadPhase);
    s.broadPhaseKind = from.broadPhaseKind;
    s.broadPhase->ShareWork(*s.pool);
    s.pairs = std::move(from.pairs);
    s.edited = std::move(from.edited);
    s.isEdited = from.isEdited;
    s.islands = {};
    s.active = {};
    s.substepGroups = {};
    s.solverScratch.Trim();
    s.restScratches = RestScratches{};
    s.solverScratch.anglesHaveRests = true;
    s.idleSubsteps = WorldState::notIdle;
    NearStatics& near = from.continuousScratch.nearStatics;
    near = s.continuousScratch.nearStatics;  // remembers whether it may be used
    near.Trim();
    s.continuousScratch = std::move(from.continuousScratch);
    s.featureCounts = from.featureCounts;
    s.autoClearForces = from.autoClearForces;
    s.lastInverseDt = from.lastInverseDt;
    s.log.Restart({});
}

}  // namespace

std::vector<std::byte> SaveWorld(const World& world) {
    const WorldState& s = world.GetState();
    if (s.IsLocked()) {
        s.Refuse(ErrorCode::locked, "SaveWorld", "world", "save outside of Step and callbacks");
        return {};
    }
    Header header{magic, snapshotVersion, snapshotByteOrder, 0, 0};
    ImageWriter writer;
    writer.Append(std::as_bytes(std::span(&header, 1)));
    VisitWorld(s, writer);
    std::vector<std::byte> image = std::move(writer.Bytes());
    header.size = image.size();
    header.checksum = ChecksumOf(std::span(image).subspan(sizeof(header)));
    std::memcpy(image.data(), &header, sizeof(header));
    return image;
}

std::unique_ptr<World> LoadWorld(std::span<const std::byte> image, SnapshotError* error) {
    SnapshotError found = SnapshotError::ok;
    const std::span<const std::byte> content = Open(image, found);
    std::unique_ptr<World> world = found == SnapshotError::ok ? MakeWorld(content) : nullptr;
    if (found == SnapshotError::ok && world == nullptr) found = SnapshotError::badContent;
    if (error != nullptr) *error = found;
    return world;
}

SnapshotError RestoreWorld(World& world, std::span<const std::byte> image) {
    WorldState& s = world.GetState();
    if (s.IsLocked() || s.recorder != nullptr) {
        s.Refuse(ErrorCode::locked, "RestoreWorld", "world", "restore outside of Step, callbacks and recordings");
        return SnapshotError::refused;
    }
    SnapshotError found = SnapshotError::ok;
    const std::unique_ptr<World> saved = LoadWorld(image, &found);
    if (saved == nullptr) return found;
    WorldState& from = saved->GetState();
    if (const Finding bad = Check(WithOwnSettings(s.def, from.def))) {
        s.Refuse(bad.code, "RestoreWorld", bad.field, bad.cure);
        return SnapshotError::refused;
    }
    const Features missing = UsedOf(CountFeatureUsers(from)) - AllowedFeatures(s.def);
    if (!missing.IsEmpty()) {
        s.Refuse(ErrorCode::missingFeature, "RestoreWorld", GetName(missing.First()), "add it by World::SetFeatures");
        return SnapshotError::refused;
    }
    MoveState(from, s);
    return SnapshotError::ok;
}

}  // namespace scree
