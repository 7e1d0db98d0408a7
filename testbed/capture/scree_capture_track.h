// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The recorder: world in, track out, one record a step. BasicTrack is used by the name Track of an engine's header.
// Step reads the world; scree_capture_pack.h has what becomes of it.

#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scree_capture_format.h"
#include "scree_capture_pack.h"
#include "scree_capture_scene.h"

namespace scree_capture {
namespace detail {

/// A body that is recorded.
template <typename Body>
struct BodySlot {
    Body* body;
    std::uint64_t quick, identity;  ///< change when another body or other fixtures stand at the address
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

    /// A touching contact: its sides, the normal, and of each point x, y, separation and both impulses.
    struct ContactRecord {
        typename Api::ContactSides sides;
        int count;
        bool isSensor;
        float values[12];
    };
    typedef std::vector<ContactRecord> Contacts;

    void ReadContacts(typename Api::World& world, Contacts& contacts) {
        contacts.clear();
        for (typename Api::Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            if (!c->IsTouching()) continue;
            contacts.resize(contacts.size() + 1);
            Read(*c, contacts.back());
        }
    }
    static std::size_t CountBytes(const Contacts& contacts) { return contacts.size() * sizeof(ContactRecord); }
    static void Pack(const Contacts& contacts, const typename Api::Places& places, Bytes& bytes) {
        ContactBytes out(bytes);
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const ContactRecord& c = contacts[k];
            const std::pair<Place, Place> pair = Api::PlacesOf(c.sides, places);
            unsigned char* end = out.Begin(pair.first, pair.second, c.count, c.isSensor, c.values[0], c.values[1]);
            for (int i = 2; i < 2 + 5 * c.count; ++i) end = PutFloat(end, c.values[i]);
            out.End(end);
        }
    }

private:
    static void Read(typename Api::Contact& contact, ContactRecord& record) {
        const typename Api::Manifold& manifold = Api::ManifoldOf(contact);
        record.sides = Api::SidesOf(contact);
        record.isSensor = contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor();
        record.count = manifold.pointCount;
        record.values[0] = record.values[1] = 0.0f;
        if (record.count == 0) return;
        typename Api::WorldManifold points;
        contact.GetWorldManifold(&points);
        record.values[0] = points.normal.x;
        record.values[1] = points.normal.y;
        for (int i = 0; i < record.count; ++i) {
            float* to = record.values + 2 + 5 * i;
            to[0] = points.points[i].x;
            to[1] = points.points[i].y;
            to[2] = points.separations[i];
            to[3] = manifold.points[i].normalImpulse;
            to[4] = manifold.points[i].tangentImpulse;
        }
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
        : m_world(world), m_path(path), m_options(options), m_ring(options) {
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
        if (IsRing()) {
            if (!m_record) m_record.reset(new StepRecord<Api>());
        } else {
            OpenFile();
            if (!m_record) m_record = m_file->TakeSpare();
        }
        Gather();
        if (!IsRing() && !m_file->HasRoom()) {
            SkipStep();
            return;
        }
        m_record->isKey = m_stepsSinceKey >= keyInterval || m_needsKey;
        ReadStep(dt);
        m_stepsSinceKey = m_record->isKey ? 1 : m_stepsSinceKey + 1;
        m_needsKey = false;
        IsRing() ? Keep() : Push();
    }

    /// What people call a body, in reports and inspectors.
    void Name(const Body* body, const std::string& name) {
        m_namesToCome.insert(std::make_pair(static_cast<const void*>(body), name));
    }
    /// A word on the step that is recorded next.
    void Mark(const std::string& text) { m_marks.push_back(text); }

    /// Keeps the last seconds in memory instead of writing: a flight recorder. Call it before the first step.
    void KeepLast(double seconds) { m_options.keepLast = seconds; }
    /// Writes what a flight recorder keeps, replacing what it wrote before; false if the file cannot be written.
    /// A crash handler may call it as a last resort. It reads nothing of the world, but it is not async-signal-safe: it
    /// allocates memory and opens a file. If the crash is inside of malloc, of Step or of Save itself, or has damaged
    /// the heap, it may fault again or wait for ever for a lock. So the handler first restores the default action of
    /// the signal and calls alarm. After an overflow of the stack it needs sigaltstack.
    bool Save() { return Save(m_path); }
    bool Save(const std::string& path) {
        EndKept();
        Output file(path);
        file.Append(m_header, false);
        if (!m_gone.IsEmpty()) file.Append(PayloadOf(m_gone), false);
        for (std::size_t i = 0; i < m_kept.size(); ++i) file.Append(m_kept[i].payload, true);
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
        std::shared_ptr<BodyTable> table(new BodyTable());
        for (Body* b = m_world.GetBodyList(); b != nullptr; b = b->GetNext()) AddSlot(m_slots, *table, b, bodies.at(b));
        m_table = table;
        for (Joint* j = m_world.GetJointList(); j != nullptr; j = j->GetNext()) {
            m_joints.push_back(JointSlot{j, Api::IdentityOf(m_world, *j), joints.at(j)});
        }
        m_counts = Api::CountObjects(m_world);
        MapFixtures();
    }

    void AddSlot(std::vector<Slot>& slots, BodyTable& table, Body* body, std::int64_t number) {
        slots.push_back(Slot{body, Api::QuickIdentityOf(m_world, *body), Api::IdentityOf(m_world, *body)});
        table.numbers.push_back(number);
        table.created.push_back(StateOf(*body));
        table.before.push_back(-1);
    }

    /// States of all bodies in the list's order, and events where objects came, went or changed.
    void Gather() {
        if (m_mustResync || !GatherStates() || Api::CountObjects(m_world) != m_counts || HaveJointsChanged()) {
            Resync();
            (void)GatherStates();
            m_mustResync = false;
        }
        if (!m_namesToCome.empty()) GatherNames();
    }

    /// A level may name all of its bodies at once.
    void GatherNames() {
        typedef std::multimap<const void*, std::string>::const_iterator Name;
        for (std::size_t k = 0; k < m_slots.size(); ++k) {
            const std::pair<Name, Name> names = m_namesToCome.equal_range(m_slots[k].body);
            for (Name name = names.first; name != names.second; ++name) {
                CborWriter out;
                out.BeginArray();
                out.Value(m_table->numbers[k]);
                out.Value(name->second);
                out.EndArray();
                m_events.names.push_back(Item{m_table->numbers[k], std::move(out.GetBytes()), -1});
            }
        }
        m_namesToCome.clear();
    }

    /// False if the list of bodies is no longer that of the slots.
    bool GatherStates() {
        m_record->states.resize(m_slots.size());
        return m_reader.ReadBodies(m_world, m_slots, m_record->states);
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
        std::shared_ptr<BodyTable> table(new BodyTable());
        std::vector<std::size_t> made;
        std::vector<std::int64_t> replaced;
        for (Body* b = m_world.GetBodyList(); b != nullptr; b = b->GetNext()) {
            const std::unordered_map<const void*, std::size_t>::const_iterator found = known.find(b);
            const bool isKnown = found != known.end();
            if (isKnown && m_slots[found->second].identity == Api::IdentityOf(m_world, *b)) {
                lives[found->second] = true;
                slots.push_back(m_slots[found->second]);
                table->numbers.push_back(m_table->numbers[found->second]);
                table->created.push_back(m_table->created[found->second]);
                table->before.push_back(static_cast<std::ptrdiff_t>(found->second));
                continue;
            }
            made.push_back(slots.size());
            replaced.push_back(isKnown ? m_table->numbers[found->second] : -1);
            AddSlot(slots, *table, b, -1);
        }
        for (std::size_t k = 0; k < m_slots.size(); ++k) {
            if (!lives[k]) m_events.destroyed.push_back(m_table->numbers[k]);
        }
        // The newest come first in the list.
        for (std::size_t i = made.size(); i-- > 0;) {
            const Slot& slot = slots[made[i]];
            const std::int64_t number = table->numbers[made[i]] = m_nextBody++;
            CborWriter out;
            out.BeginMap();
            out.Key("id");
            out.Value(number);
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
            m_events.created.push_back(Item{number, std::move(out.GetBytes()), replaced[i]});
        }
        m_slots.swap(slots);
        m_table = table;
        ResyncJoints();
        m_counts = Api::CountObjects(m_world);
        MapFixtures();
    }

    void ResyncJoints() {
        Numbers bodies, joints;
        for (std::size_t k = 0; k < m_slots.size(); ++k) bodies[m_slots[k].body] = m_table->numbers[k];
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
            m_events.joints.push_back(Item{slots[made[i].first].number, std::move(out.GetBytes()), -1});
        }
        m_joints.swap(slots);
    }

    void MapFixtures() {
        if (!m_options.contacts && !m_options.tree) return;
        std::shared_ptr<typename Api::Places> places(new typename Api::Places());
        for (std::size_t k = 0; k < m_slots.size(); ++k) {
            const std::vector<std::vector<const typename Api::Fixture*>> groups =
                SceneWriter<Api, CborWriter>::FixturesOf(*m_slots[k].body);
            for (std::size_t i = 0; i < groups.size(); ++i) {
                for (std::size_t child = 0; child < groups[i].size(); ++child) {
                    (*places)[groups[i][child]] =
                        Place{m_table->numbers[k], static_cast<std::int64_t>(i), static_cast<std::int64_t>(child)};
                }
            }
        }
        m_places = places;
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
        m_file.reset(new TrackFile<Api>(m_path, m_options));
        m_file->Push(m_header);
    }

    void SkipStep() {
        ++m_skipped;
        m_needsKey = true;
        m_gone.Add(std::move(m_events));
        m_events = Events();
    }

    void ReadStep(float dt) {
        StepRecord<Api>& record = *m_record;
        record.step = m_step;
        record.dt = dt;
        record.bodies = m_table;
        record.events = std::move(m_events);
        m_events = Events();
        record.marks.swap(m_marks);
        if (m_options.contacts) {
            record.places = m_places;
            record.contactCount = static_cast<std::int64_t>(m_world.GetContactCount());
            m_reader.ReadContacts(m_world, record.contacts);
        }
        if (m_options.tree) {
            record.nodes.clear();
            Api::WriteNodes(m_world, *m_places, record.nodes);
        }
        if (m_options.stages) {
            CborWriter out;
            out.BeginMap();
            Api::WriteStages(m_world, out);
            out.EndMap();
            record.stages.swap(out.GetBytes());
        }
    }

    void Push() {
        if (!m_gone.IsEmpty()) m_file->Push(PayloadOf(m_gone));
        m_gone = Events();
        m_file->Push(std::move(m_record));
    }

    // A flight recorder packs what it keeps in Step.

    void Keep() {
        if (m_record->isKey) EndKept();
        m_ring.Add(*m_record);
        if (m_ring.IsFull()) EndKept();
    }
    void EndKept() {
        if (m_ring.IsEmpty()) return;
        m_kept.push_back(m_ring.Take());
        Trim();
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
    std::unique_ptr<TrackFile<Api>> m_file;
    std::string m_error;

    std::vector<Slot> m_slots;                 ///< in the order of the world's list
    std::shared_ptr<const BodyTable> m_table;  ///< of the slots
    std::vector<JointSlot> m_joints;
    std::int64_t m_nextBody = 0, m_nextJoint = 0;
    std::uint64_t m_counts = 0;
    std::shared_ptr<const typename Api::Places> m_places;
    typename Api::Reader m_reader;
    bool m_mustResync = false;

    std::int64_t m_step = 0;
    int m_stepsSinceKey = 0, m_skipped = 0;
    bool m_needsKey = false, m_isClosed = false;
    std::multimap<const void*, std::string> m_namesToCome;
    std::vector<std::string> m_marks;
    Events m_events;
    std::unique_ptr<StepRecord<Api>> m_record;  ///< that is being filled

    BlockMaker<Api> m_ring;    ///< of a flight recorder
    std::deque<Block> m_kept;  ///< the same
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
