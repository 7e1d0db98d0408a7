// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The recorder: world in, track out, one record a step. BasicTrack is used by the name Track of an engine's header.
// Blocks of steps begin with every body's state after `keyInterval` steps at the latest; only whole blocks are written.

#pragma once

#include <cfenv>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scree_capture_format.h"
#include "scree_capture_scene.h"

namespace scree_capture {
namespace detail {

/// Steps from one complete state to the next: what a reader has to decode to get at any step.
static const int keyInterval = 120;
/// Bytes after which a block is written.
static const std::size_t blockBytes = 256u << 10;

/// An item of a list of an event, with the number that it is about.
struct Item {
    std::int64_t number;
    Bytes bytes;
};

/// What happened to objects besides moving.
struct Events {
    std::vector<Item> created, joints;
    std::vector<std::int64_t> destroyed, destroyedJoints;
    std::vector<Item> names;

    bool IsEmpty() const {
        return created.empty() && joints.empty() && destroyed.empty() && destroyedJoints.empty() && names.empty();
    }
    /// Adds what came later. Objects that came and went leave no trace, so that memory stays within what lives.
    void Add(Events&& later) {
        Append(created, later.created);
        Append(joints, later.joints);
        Append(names, later.names);
        Remove(created, destroyed, later.destroyed);
        Remove(joints, destroyedJoints, later.destroyedJoints);
    }

    void Write(CborWriter& out) const {
        WriteItems(out, "created", created);
        WriteNumbers(out, "destroyed", destroyed);
        WriteItems(out, "joints", joints);
        WriteNumbers(out, "destroyedJoints", destroyedJoints);
        WriteItems(out, "names", names);
    }

private:
    static void Append(std::vector<Item>& items, std::vector<Item>& later) {
        for (std::size_t i = 0; i < later.size(); ++i) items.push_back(std::move(later[i]));
    }
    static void Remove(std::vector<Item>& made, std::vector<std::int64_t>& gone,
                       const std::vector<std::int64_t>& later) {
        for (std::size_t i = 0; i < later.size(); ++i) {
            bool wasMade = false;
            for (std::size_t k = 0; k < made.size() && !wasMade; ++k) {
                if (made[k].number != later[i]) continue;
                made.erase(made.begin() + static_cast<std::ptrdiff_t>(k));
                wasMade = true;
            }
            if (!wasMade) gone.push_back(later[i]);
        }
    }
    static void WriteItems(CborWriter& out, const char* key, const std::vector<Item>& items) {
        if (items.empty()) return;
        out.Key(key);
        out.BeginArray();
        for (std::size_t i = 0; i < items.size(); ++i) out.Raw(items[i].bytes);
        out.EndArray();
    }
    static void WriteNumbers(CborWriter& out, const char* key, const std::vector<std::int64_t>& numbers) {
        if (numbers.empty()) return;
        out.Key(key);
        out.BeginArray();
        for (std::size_t i = 0; i < numbers.size(); ++i) out.Value(numbers[i]);
        out.EndArray();
    }
};

/// A payload of steps and what they changed besides poses.
struct Block {
    Bytes payload;
    Events events;
    double seconds = 0.0;
    bool beginsWithKey = false;
};

/// Where a fixture stands in a track.
struct Place {
    std::int64_t body;
    std::int64_t fixture, child;
};

/// A body that is recorded, as it was in the last step.
template <typename Body>
struct BodySlot {
    Body* body;
    std::uint64_t quick, identity;  ///< change when another body or other fixtures stand at the address
    std::int64_t number;
    State last, created;
};

/// The most bytes that a place, and a contact, take.
static const std::size_t mostPlaceBytes = 30, mostContactBytes = 2 * mostPlaceBytes + 9 + 2 * 20;

inline unsigned char* PutPlace(unsigned char* out, const Place& place) {
    out = PutVarint(out, static_cast<std::uint64_t>(place.body));
    out = PutVarint(out, static_cast<std::uint64_t>(place.fixture));
    return PutVarint(out, static_cast<std::uint64_t>(place.child));
}
inline void PutPlace(Bytes& bytes, const Place& place) {
    unsigned char text[mostPlaceBytes];
    bytes.insert(bytes.end(), text, PutPlace(text, place));
}

/// The end of bytes that grow by whole contacts: a vector is slow byte by byte.
class ContactBytes {
public:
    explicit ContactBytes(Bytes& bytes) : m_bytes(bytes), m_used(bytes.size()) {}
    ~ContactBytes() { m_bytes.resize(m_used); }
    ContactBytes(const ContactBytes&) = delete;
    ContactBytes& operator=(const ContactBytes&) = delete;

    /// A contact with `count` points; of each the caller then writes x, y, separation and both impulses.
    unsigned char* Begin(const Place& a, const Place& b, int count, bool isSensor, float normalX, float normalY) {
        if (m_bytes.size() - m_used < mostContactBytes) m_bytes.resize(m_used + 64 * mostContactBytes);
        unsigned char* out = PutPlace(PutPlace(m_bytes.data() + m_used, a), b);
        *out++ = static_cast<unsigned char>(count + (isSensor ? 4 : 0));
        return PutFloat(PutFloat(out, normalX), normalY);
    }
    void End(const unsigned char* end) { m_used = static_cast<std::size_t>(end - m_bytes.data()); }

private:
    Bytes& m_bytes;
    std::size_t m_used;
};

/// Reads a world by its lists and accessors.
template <typename Api>
class ListReader {
public:
    /// States of all bodies; false if the list of bodies is no longer that of the slots.
    bool ReadBodies(typename Api::World& world, const std::vector<BodySlot<typename Api::Body>>& slots,
                    std::vector<State>& now) {
        std::size_t k = 0;
        for (const typename Api::Body* b = world.GetBodyList(); b != nullptr; b = b->GetNext(), ++k) {
            if (k == slots.size() || slots[k].body != b || slots[k].quick != Api::QuickIdentityOf(world, *b)) {
                return false;
            }
            Api::ReadState(*b, now[k]);
        }
        return k == slots.size();
    }
    /// Appends the touching contacts.
    void WriteContacts(typename Api::World& world, const typename Api::Places& places, Bytes& bytes) {
        ContactBytes out(bytes);
        for (typename Api::Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            if (c->IsTouching()) WriteContact(*c, places, out);
        }
    }

private:
    static void WriteContact(typename Api::Contact& contact, const typename Api::Places& places, ContactBytes& out) {
        const std::pair<Place, Place> sides = Api::PlacesOf(contact, places);
        const typename Api::Manifold& manifold = Api::ManifoldOf(contact);
        const bool isSensor = contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor();
        const int count = manifold.pointCount;
        typename Api::WorldManifold points;
        if (count > 0) {
            contact.GetWorldManifold(&points);
        } else {
            points.normal.Set(0.0f, 0.0f);
        }
        unsigned char* end = out.Begin(sides.first, sides.second, count, isSensor, points.normal.x, points.normal.y);
        for (int i = 0; i < count; ++i) {
            end = PutFloat(PutFloat(end, points.points[i].x), points.points[i].y);
            end = PutFloat(end, points.separations[i]);
            end = PutFloat(PutFloat(end, manifold.points[i].normalImpulse), manifold.points[i].tangentImpulse);
        }
        out.End(end);
    }
};

template <typename Api>
class BasicTrack {
public:
    typedef typename Api::World World;
    typedef typename Api::Body Body;
    typedef typename Api::Joint Joint;

    /// Records a world from its present state on. The world must outlive the track, or Close be called first.
    BasicTrack(World& world, const std::string& path, const Options& options = Options())
        : m_world(world), m_path(path), m_options(options) {
        WriteHeader();
    }
    ~BasicTrack() { Close(); }
    BasicTrack(const BasicTrack&) = delete;
    BasicTrack& operator=(const BasicTrack&) = delete;

    /// Call it after every step of the world, with the step's length in seconds.
    void Step(float dt) {
        if (m_isClosed) return;
        Begin(dt);
        ++m_step;
        Gather();
        const bool mustKey = m_stepsSinceKey >= keyInterval || m_needsKey;
        if (mustKey && m_blockSteps > 0) EndBlock();
        if (m_blockSteps == 0 && !HasRoom()) {
            SkipStep();
            return;
        }
        WriteStep(dt, mustKey);
        if (m_out.GetBytes().size() >= blockBytes) EndBlock();
    }

    /// What people call a body, in reports and inspectors.
    void Name(const Body* body, const std::string& name) {
        m_namesToCome.push_back(std::make_pair(static_cast<const void*>(body), name));
    }
    /// A word on the step that is recorded next.
    void Mark(const std::string& text) { m_marks.push_back(text); }

    /// Keeps the last seconds in memory instead of writing: a flight recorder. Call it before the first step.
    void KeepLast(double seconds) { m_options.keepLast = seconds; }
    /// Writes what a flight recorder keeps, replacing what it wrote before; false if the file cannot be written.
    bool Save() { return Save(m_path); }
    bool Save(const std::string& path) {
        if (m_blockSteps > 0) EndBlock();
        Output file(path, static_cast<std::size_t>(-1));
        file.Push(m_header, false);
        PushEvents(file, m_gone);
        for (std::size_t i = 0; i < m_kept.size(); ++i) file.Push(m_kept[i].payload, true);
        file.Flush();
        const std::string error = file.GetError();
        if (!error.empty()) m_error = error;
        return error.empty();
    }

    /// All objects are looked at anew in the next step, not only those whose address changed: after a body was
    /// destroyed and another made at its address between two steps.
    void Refresh() { m_mustResync = true; }

    /// Returns once all steps so far are in the file; without it, all are when the track is closed or destroyed.
    void Flush() {
        if (m_isClosed || IsRing()) return;
        if (m_blockSteps > 0) EndBlock();
        OpenFile();
        m_file->Flush();
    }
    void Close() {
        if (m_isClosed) return;
        Flush();
        m_isClosed = true;
        if (m_file) TakeError();
        m_file.reset();
    }
    /// What went wrong, or nothing.
    std::string GetError() {
        TakeError();
        return m_error;
    }
    /// Steps that found no room in memory, since the disk was too slow.
    int GetSkippedSteps() const { return m_skipped; }

private:
    typedef BodySlot<Body> Slot;
    struct JointSlot {
        const Joint* joint;
        std::uint64_t identity;
        std::int64_t number;
    };

    bool IsRing() const { return m_options.keepLast > 0.0; }

    static State StateOf(const Body& body) {
        State state;
        Api::ReadState(body, state);
        return state;
    }

    // Objects.

    void WriteHeader() {
        CborWriter out;
        out.BeginMap();
        out.Key("header");
        out.BeginMap();
        out.Key("format");
        out.Value("scree-track");
        out.Key("version");
        out.Value(std::int64_t(1));
        out.Key("writer");
        out.Value(Api::Writer());
        out.Key("engine");
        out.Value(Api::Engine());
        m_timeStepAt[0] = BeginLater(out, 1.0f / 60.0f);
        out.Key("scene");
        Numbers bodies, joints;
        m_timeStepAt[1] = WriteWorld<Api>(out, m_world, m_options, bodies, joints);
        out.EndMap();
        out.EndMap();
        m_header.swap(out.GetBytes());
        m_nextBody = static_cast<std::int64_t>(bodies.size());
        m_nextJoint = static_cast<std::int64_t>(joints.size());
        for (Body* b = m_world.GetBodyList(); b != nullptr; b = b->GetNext()) AddSlot(m_slots, b, bodies.at(b));
        for (Joint* j = m_world.GetJointList(); j != nullptr; j = j->GetNext()) {
            m_joints.push_back(JointSlot{j, Api::IdentityOf(m_world, *j), joints.at(j)});
        }
        m_counts = Api::CountObjects(m_world);
        MapFixtures();
    }

    void AddSlot(std::vector<Slot>& slots, Body* body, std::int64_t number) {
        Slot slot;
        slot.body = body;
        slot.quick = Api::QuickIdentityOf(m_world, *body);
        slot.identity = Api::IdentityOf(m_world, *body);
        slot.number = number;
        slot.last = slot.created = StateOf(*body);
        slots.push_back(slot);
    }

    /// States of all bodies in the list's order, and events where objects came, went or changed.
    void Gather() {
        if (m_mustResync || !GatherStates() || Api::CountObjects(m_world) != m_counts || HaveJointsChanged()) {
            Resync();
            (void)GatherStates();
            m_mustResync = false;
        }
        for (std::size_t i = 0; i < m_namesToCome.size(); ++i) {
            for (std::size_t k = 0; k < m_slots.size(); ++k) {
                if (m_slots[k].body != m_namesToCome[i].first) continue;
                CborWriter out;
                out.BeginArray();
                out.Value(m_slots[k].number);
                out.Value(m_namesToCome[i].second);
                out.EndArray();
                m_events.names.push_back(Item{m_slots[k].number, std::move(out.GetBytes())});
            }
        }
        m_namesToCome.clear();
    }

    /// False if the list of bodies is no longer that of the slots.
    bool GatherStates() {
        m_now.resize(m_slots.size());
        return m_reader.ReadBodies(m_world, m_slots, m_now);
    }

    bool HaveJointsChanged() {
        if (m_joints.empty()) return m_world.GetJointList() != nullptr;
        std::size_t k = 0;
        for (const Joint* j = m_world.GetJointList(); j != nullptr; j = j->GetNext(), ++k) {
            if (k == m_joints.size() || m_joints[k].joint != j ||
                m_joints[k].identity != Api::IdentityOf(m_world, *j)) {
                return true;
            }
        }
        return k != m_joints.size();
    }

    void Resync() {
        std::unordered_map<const void*, std::size_t> known;
        for (std::size_t k = 0; k < m_slots.size(); ++k) known[m_slots[k].body] = k;
        std::vector<bool> lives(m_slots.size(), false);
        std::vector<Slot> slots;
        std::vector<std::size_t> made;
        std::vector<std::int64_t> replaced;
        for (Body* b = m_world.GetBodyList(); b != nullptr; b = b->GetNext()) {
            const std::unordered_map<const void*, std::size_t>::const_iterator found = known.find(b);
            const bool isKnown = found != known.end();
            if (isKnown && m_slots[found->second].identity == Api::IdentityOf(m_world, *b)) {
                lives[found->second] = true;
                slots.push_back(m_slots[found->second]);
                continue;
            }
            made.push_back(slots.size());
            replaced.push_back(isKnown ? m_slots[found->second].number : -1);
            AddSlot(slots, b, -1);
        }
        for (std::size_t k = 0; k < m_slots.size(); ++k) {
            if (!lives[k]) m_events.destroyed.push_back(m_slots[k].number);
        }
        // The newest come first in the list.
        for (std::size_t i = made.size(); i-- > 0;) {
            Slot& slot = slots[made[i]];
            slot.number = m_nextBody++;
            CborWriter out;
            out.BeginMap();
            out.Key("id");
            out.Value(slot.number);
            if (replaced[i] >= 0) {
                out.Key("was");
                out.Value(replaced[i]);
            }
            const std::uint64_t data = ToNumber(slot.body->GetUserData());
            if (data != 0 && data <= mostUserData) {
                out.Key("userData");
                out.Value(static_cast<std::int64_t>(data));
            }
            out.Key("body");
            SceneWriter<Api, CborWriter>(out).WriteBody(*slot.body);
            out.EndMap();
            m_events.created.push_back(Item{slot.number, std::move(out.GetBytes())});
        }
        m_slots.swap(slots);
        ResyncJoints();
        m_counts = Api::CountObjects(m_world);
        MapFixtures();
    }

    void ResyncJoints() {
        Numbers bodies, joints;
        for (std::size_t k = 0; k < m_slots.size(); ++k) bodies[m_slots[k].body] = m_slots[k].number;
        std::unordered_map<const void*, std::size_t> known;
        for (std::size_t k = 0; k < m_joints.size(); ++k) known[m_joints[k].joint] = k;
        std::vector<JointSlot> slots;
        std::vector<std::pair<std::size_t, Joint*>> made;
        std::vector<bool> lives(m_joints.size(), false);
        for (Joint* j = m_world.GetJointList(); j != nullptr; j = j->GetNext()) {
            const std::unordered_map<const void*, std::size_t>::const_iterator found = known.find(j);
            const std::uint64_t identity = Api::IdentityOf(m_world, *j);
            if (found != known.end() && m_joints[found->second].identity == identity) {
                lives[found->second] = true;
                slots.push_back(m_joints[found->second]);
            } else {
                made.push_back(std::make_pair(slots.size(), j));
                slots.push_back(JointSlot{j, identity, -1});
            }
        }
        for (std::size_t k = 0; k < m_joints.size(); ++k) {
            if (!lives[k]) m_events.destroyedJoints.push_back(m_joints[k].number);
        }
        for (std::size_t i = made.size(); i-- > 0;) slots[made[i].first].number = m_nextJoint++;
        for (std::size_t k = 0; k < slots.size(); ++k) joints[slots[k].joint] = slots[k].number;
        for (std::size_t i = made.size(); i-- > 0;) {
            CborWriter out;
            out.BeginMap();
            out.Key("id");
            out.Value(slots[made[i].first].number);
            out.Key("joint");
            SceneWriter<Api, CborWriter>(out).WriteJoint(*made[i].second, bodies, joints);
            out.EndMap();
            m_events.joints.push_back(Item{slots[made[i].first].number, std::move(out.GetBytes())});
        }
        m_joints.swap(slots);
    }

    void MapFixtures() {
        m_places.clear();
        if (!m_options.contacts && !m_options.tree) return;
        for (std::size_t k = 0; k < m_slots.size(); ++k) {
            const std::vector<std::vector<const typename Api::Fixture*>> groups =
                SceneWriter<Api, CborWriter>::FixturesOf(*m_slots[k].body);
            for (std::size_t i = 0; i < groups.size(); ++i) {
                for (std::size_t child = 0; child < groups[i].size(); ++child) {
                    m_places[groups[i][child]] =
                        Place{m_slots[k].number, static_cast<std::int64_t>(i), static_cast<std::int64_t>(child)};
                }
            }
        }
    }

    // Records.

    void Begin(float dt) {
        // The first step tells what the header left open; what no scene can have (0: no time passes) stays out of it.
        if (m_step > 0 || !(dt >= 1e-6f && dt <= 10.0f)) return;
        CborWriter patch;
        patch.GetBytes().swap(m_header);
        for (std::size_t i = 0; i < 2; ++i) patch.Patch(m_timeStepAt[i], BitsOf(dt));
        patch.GetBytes().swap(m_header);
    }

    void OpenFile() {
        if (m_file || IsRing()) return;
        m_file.reset(new Output(m_path, m_options.memory));
        m_file->Push(m_header, false);
    }

    bool HasRoom() {
        if (IsRing()) return true;
        OpenFile();
        return m_file->HasRoom();
    }

    void SkipStep() {
        ++m_skipped;
        m_needsKey = true;
        m_gone.Add(std::move(m_events));
        m_events = Events();
        for (std::size_t k = 0; k < m_slots.size(); ++k) m_slots[k].last = m_now[k];
    }

    void WriteStep(float dt, bool isKey) {
        if (m_blockSteps == 0) {
            m_out.Clear();
            m_out.BeginMap();
            m_out.Key("steps");
            m_out.BeginArray();
            m_block.beginsWithKey = isKey;
        }
        ++m_blockSteps;
        m_block.seconds += static_cast<double>(dt);
        // What a program has set (rounding upwards) would give other predictions than a reader makes.
        const bool canPredict = CanPredict() && std::fegetround() == FE_TONEAREST;
        m_out.BeginMap();
        m_out.Key("step");
        m_out.Value(m_step);
        m_out.Key("dt");
        m_out.Value(dt);
        if (isKey) {
            m_out.Key("key");
            m_out.Value(true);
        } else if (!canPredict) {
            m_out.Key("h");
            m_out.Value(0.0f);
        }
        m_events.Write(m_out);
        WriteBodies(isKey || !canPredict ? 0.0 : static_cast<double>(dt), isKey);
        WriteMarks();
        if (m_options.contacts) WriteContacts();
        if (m_options.tree) {
            m_out.Key("nodes");
            const std::size_t begin = m_out.BeginBytes();
            Api::WriteNodes(m_world, m_places, m_out.GetBytes());
            m_out.EndBytes(begin);
        }
        if (m_options.stages) {
            m_out.Key("stages");
            m_out.BeginMap();
            Api::WriteStages(m_world, m_out);
            m_out.EndMap();
        }
        m_out.EndMap();
        m_block.events.Add(std::move(m_events));
        m_events = Events();
        m_needsKey = false;
        m_stepsSinceKey = isKey ? 1 : m_stepsSinceKey + 1;
    }

    void WriteBodies(double h, bool isKey) {
        m_out.Key("bodies");
        const std::size_t begin = m_out.BeginBytes();
        Bytes& bytes = m_out.GetBytes();
        bytes.resize(begin + m_slots.size() * mostStateBytes + 4);
        unsigned char* end = bytes.data() + begin;
        std::int64_t lastNumber = 0;
        for (std::size_t k = 0; k < m_slots.size(); ++k) {
            Slot& slot = m_slots[k];
            const State& now = m_now[k];
            const State& before = isKey ? slot.created : slot.last;
            if (now.IsSame(before)) {
                slot.last = now;
                continue;
            }
            end = PackState(end, slot.number, lastNumber, now, before, h);
            lastNumber = slot.number;
            slot.last = now;
        }
        bytes.resize(static_cast<std::size_t>(end - bytes.data()));
        m_out.EndBytes(begin);
    }

    void WriteMarks() {
        if (m_marks.empty()) return;
        m_out.Key("marks");
        m_out.BeginArray();
        for (std::size_t i = 0; i < m_marks.size(); ++i) m_out.Value(m_marks[i]);
        m_out.EndArray();
        m_marks.clear();
    }

    void WriteContacts() {
        m_out.Key("contactCount");
        m_out.Value(static_cast<std::int64_t>(m_world.GetContactCount()));
        m_out.Key("contacts");
        const std::size_t begin = m_out.BeginBytes();
        m_reader.WriteContacts(m_world, m_places, m_out.GetBytes());
        m_out.EndBytes(begin);
    }

    static void PushEvents(Output& file, const Events& events) {
        if (events.IsEmpty()) return;
        CborWriter out;
        out.BeginMap();
        out.Key("objects");
        out.BeginMap();
        events.Write(out);
        out.EndMap();
        out.EndMap();
        file.Push(std::move(out.GetBytes()), false);
    }

    void EndBlock() {
        m_out.EndArray();
        m_out.EndMap();
        m_block.payload.swap(m_out.GetBytes());
        m_out.Clear();
        m_blockSteps = 0;
        if (IsRing()) {
            m_kept.push_back(std::move(m_block));
            Trim();
        } else {
            OpenFile();
            PushEvents(*m_file, m_gone);
            m_gone = Events();
            m_file->Push(std::move(m_block.payload), true);
            m_out.GetBytes() = m_file->TakeSpare();
            m_out.Clear();
        }
        m_block = Block();
    }

    /// Drops blocks that are too old or too many, up to one that begins with all states.
    void Trim() {
        double seconds = 0.0;
        std::size_t bytes = 0;
        for (std::size_t i = 0; i < m_kept.size(); ++i) {
            seconds += m_kept[i].seconds;
            bytes += m_kept[i].payload.size();
        }
        for (;;) {
            std::size_t next = 1;
            double older = m_kept.empty() ? 0.0 : m_kept[0].seconds;
            while (next < m_kept.size() && !m_kept[next].beginsWithKey) older += m_kept[next++].seconds;
            if (next >= m_kept.size()) return;
            if (seconds - older < m_options.keepLast && bytes <= m_options.memory) return;
            for (; next > 0; --next) {
                seconds -= m_kept.front().seconds;
                bytes -= m_kept.front().payload.size();
                m_gone.Add(std::move(m_kept.front().events));
                m_kept.pop_front();
            }
        }
    }

    void TakeError() {
        if (m_file && m_error.empty()) m_error = m_file->GetError();
    }

    World& m_world;
    std::string m_path;
    Options m_options;
    Bytes m_header;
    std::size_t m_timeStepAt[2];
    std::unique_ptr<Output> m_file;
    std::string m_error;

    std::vector<Slot> m_slots;  ///< in the order of the world's list
    std::vector<State> m_now;   ///< of the slots, after the last step
    std::vector<JointSlot> m_joints;
    std::int64_t m_nextBody = 0, m_nextJoint = 0;
    std::uint64_t m_counts = 0;
    typename Api::Places m_places;
    typename Api::Reader m_reader;
    bool m_mustResync = false;

    std::int64_t m_step = 0;
    int m_stepsSinceKey = 0, m_skipped = 0;
    bool m_needsKey = false, m_isClosed = false;
    std::vector<std::pair<const void*, std::string>> m_namesToCome;
    std::vector<std::string> m_marks;
    Events m_events;

    CborWriter m_out;  ///< of the block that is being filled
    int m_blockSteps = 0;
    Block m_block;
    std::deque<Block> m_kept;  ///< of a flight recorder
    Events m_gone;             ///< of steps that were dropped or skipped
};

/// Writes a world as a scene file, `*.scene.json`; false if it cannot be written.
template <typename Api>
bool WriteSceneFile(typename Api::World& world, const std::string& path, const Options& options) {
    JsonWriter out;
    Numbers bodies, joints;
    (void)WriteWorld<Api>(out, world, options, bodies, joints);
    return WriteText(path, out.GetText());
}

}  // namespace detail
}  // namespace scree_capture
