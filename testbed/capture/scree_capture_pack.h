// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a step left, as it was read, and how it becomes bytes of a track. Packing takes longer than reading, so a file
// has a thread that packs and writes. Blocks of steps begin with every body's state after `keyInterval` steps at the
// latest; only whole blocks are written.

#pragma once

#include <algorithm>
#include <cfenv>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#ifndef SCREE_CAPTURE_NO_THREAD
#include <condition_variable>
#include <mutex>
#include <thread>
#endif

#include "scree_capture_format.h"

namespace scree_capture {
namespace detail {

/// Steps from one complete state to the next: what a reader has to decode to get at any step.
static const int keyInterval = 120;
/// Bytes after which a block is written.
static const std::size_t blockBytes = 256u << 10;
/// Of records that wait before the thread is woken, since to wake it takes as long as to read some hundred contacts.
static const std::size_t batchBytes = 4u << 20;

/// An item of a list of an event, with the number that it is about.
struct Item {
    std::int64_t number;
    Bytes bytes;
    std::int64_t was;  ///< of the body whose place it took; -1: none
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
        Remove(created, destroyed, later.destroyed, &names);
        Remove(joints, destroyedJoints, later.destroyedJoints, nullptr);
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
    static void Remove(std::vector<Item>& made, std::vector<std::int64_t>& gone, const std::vector<std::int64_t>& later,
                       std::vector<Item>* names) {
        for (std::size_t i = 0; i < later.size(); ++i) {
            // Joints name a body by the number that it had when they were made: while another has its place, it stays.
            if (Find(made, later[i]) == made.size() || IsReplaced(made, later[i])) {
                gone.push_back(later[i]);
                continue;
            }
            std::int64_t number = later[i];
            for (std::size_t k = Find(made, number); k < made.size(); k = Find(made, number)) {
                gone.erase(std::remove(gone.begin(), gone.end(), number), gone.end());
                const std::int64_t before = made[k].was;
                made.erase(made.begin() + static_cast<std::ptrdiff_t>(k));
                for (std::size_t name = 0; names != nullptr && (name = Find(*names, number)) < names->size();)
                    names->erase(names->begin() + static_cast<std::ptrdiff_t>(name));
                number = before;
            }
        }
    }
    /// Its place, or the end.
    static std::size_t Find(const std::vector<Item>& items, std::int64_t number) {
        std::size_t k = 0;
        while (k < items.size() && items[k].number != number) ++k;
        return k;
    }
    static bool IsReplaced(const std::vector<Item>& items, std::int64_t number) {
        for (std::size_t k = 0; k < items.size(); ++k) {
            if (items[k].was == number) return true;
        }
        return false;
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

/// The most bytes that a place, and a contact, take.
static const std::size_t mostPlaceBytes = 30, mostContactBytes = 2 * mostPlaceBytes + 9 + 2 * 20;

inline unsigned char* PutPlace(unsigned char* out, const Place& place) {
    out = PutVarint(out, static_cast<std::uint64_t>(place.body));
    out = PutVarint(out, static_cast<std::uint64_t>(place.fixture));
    return PutVarint(out, static_cast<std::uint64_t>(place.child));
}

/// The most bytes of a node of a tree, and the bytes of one at `out`; with a place it is a leaf.
static const std::size_t mostNodeBytes = 17 + mostPlaceBytes;
inline unsigned char* PutNode(unsigned char* out, const float (&corners)[4], const Place* place) {
    *out++ = place != nullptr ? 1 : 0;
    for (std::size_t i = 0; i < 4; ++i) out = PutFloat(out, corners[i]);
    return place != nullptr ? PutPlace(out, *place) : out;
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

/// Bodies in the order of the world's list, until it changes.
struct BodyTable {
    std::vector<std::int64_t> numbers;
    std::vector<State> created;
    std::vector<std::ptrdiff_t> before;  ///< where a body stood in the table before; -1: it is new
};

/// What a step left.
template <typename Api>
struct StepRecord {
    std::int64_t step = 0, contactCount = 0;
    float dt = 0.0f;
    bool isKey = false;
    Events events;
    std::vector<std::string> marks;
    std::shared_ptr<const BodyTable> bodies;
    std::vector<State> states;
    std::shared_ptr<const typename Api::Places> places;
    typename Api::Reader::Contacts contacts;
    Bytes nodes, stages;

    std::size_t CountBytes() const {
        return 64 + states.size() * sizeof(State) + Api::Reader::CountBytes(contacts) + nodes.size() + stages.size();
    }
};

/// Packs steps into blocks.
template <typename Api>
class BlockMaker {
public:
    explicit BlockMaker(const Options& options) : m_options(options) {}

    bool IsEmpty() const { return m_steps == 0; }
    bool IsFull() const { return m_out.GetBytes().size() >= blockBytes; }
    /// A step with all states is the first of its block: the one before was taken. The record is used up.
    void Add(StepRecord<Api>& record) {
        if (m_steps == 0) {
            m_out.Clear();
            m_out.BeginMap();
            m_out.Key("steps");
            m_out.BeginArray();
            m_block.beginsWithKey = record.isKey;
        }
        ++m_steps;
        m_block.seconds += static_cast<double>(record.dt);
        // What a program has set (rounding upwards) would give other predictions than a reader makes.
        const bool canPredict = CanPredict() && std::fegetround() == FE_TONEAREST;
        m_out.BeginMap();
        m_out.Key("step");
        m_out.Value(record.step);
        m_out.Key("dt");
        m_out.Value(record.dt);
        if (record.isKey) {
            m_out.Key("key");
            m_out.Value(true);
        } else if (!canPredict) {
            m_out.Key("h");
            m_out.Value(0.0f);
        }
        record.events.Write(m_out);
        WriteBodies(record, record.isKey || !canPredict ? 0.0 : static_cast<double>(record.dt));
        WriteMarks(record);
        if (m_options.contacts) {
            m_out.Key("contactCount");
            m_out.Value(record.contactCount);
            m_out.Key("contacts");
            const std::size_t begin = m_out.BeginBytes();
            Api::Reader::Pack(record.contacts, *record.places, m_out.GetBytes());
            m_out.EndBytes(begin);
        }
        if (m_options.tree) {
            m_out.Key("nodes");
            const std::size_t begin = m_out.BeginBytes();
            m_out.GetBytes().insert(m_out.GetBytes().end(), record.nodes.begin(), record.nodes.end());
            m_out.EndBytes(begin);
        }
        if (m_options.stages) {
            m_out.Key("stages");
            m_out.Raw(record.stages);
        }
        m_out.EndMap();
        m_block.events.Add(std::move(record.events));
        record.events = Events();
        record.marks.clear();
    }
    /// What was added since the last call. Its memory may come back by `Reuse`.
    Block Take() {
        m_out.EndArray();
        m_out.EndMap();
        Block block = std::move(m_block);
        block.payload = std::move(m_out.GetBytes());
        m_out.GetBytes() = Bytes();
        m_out.Clear();
        m_steps = 0;
        m_block = Block();
        return block;
    }
    void Reuse(Bytes&& payload) { m_out.GetBytes() = std::move(payload); }

private:
    void WriteBodies(StepRecord<Api>& record, double h) {
        const BodyTable& table = *record.bodies;
        const std::vector<State>& before = record.isKey ? table.created : LastOf(record);
        m_out.Key("bodies");
        const std::size_t begin = m_out.BeginBytes();
        Bytes& bytes = m_out.GetBytes();
        bytes.resize(begin + record.states.size() * mostStateBytes + 4);
        unsigned char* end = bytes.data() + begin;
        std::int64_t lastNumber = 0;
        for (std::size_t k = 0; k < record.states.size(); ++k) {
            const State& now = record.states[k];
            if (now.IsSame(before[k])) continue;
            end = PackState(end, table.numbers[k], lastNumber, now, before[k], h);
            lastNumber = table.numbers[k];
        }
        bytes.resize(static_cast<std::size_t>(end - bytes.data()));
        m_out.EndBytes(begin);
        m_bodies = record.bodies;
        m_last.swap(record.states);
    }

    /// The states of the step before, in the order of this one.
    const std::vector<State>& LastOf(const StepRecord<Api>& record) {
        const BodyTable& table = *record.bodies;
        if (m_bodies == record.bodies) return m_last;
        std::vector<State> last = table.created;
        for (std::size_t k = 0; m_bodies && k < last.size(); ++k) {
            if (table.before[k] >= 0) last[k] = m_last[static_cast<std::size_t>(table.before[k])];
        }
        m_last.swap(last);
        return m_last;
    }

    void WriteMarks(const StepRecord<Api>& record) {
        if (record.marks.empty()) return;
        m_out.Key("marks");
        m_out.BeginArray();
        for (std::size_t i = 0; i < record.marks.size(); ++i) m_out.Value(record.marks[i]);
        m_out.EndArray();
    }

    Options m_options;
    CborWriter m_out;
    int m_steps = 0;
    Block m_block;
    std::shared_ptr<const BodyTable> m_bodies;  ///< of the last step
    std::vector<State> m_last;
};

/// The payload of what happened in steps that were left out.
inline Bytes PayloadOf(const Events& events) {
    CborWriter out;
    out.BeginMap();
    out.Key("objects");
    out.BeginMap();
    events.Write(out);
    out.EndMap();
    out.EndMap();
    return std::move(out.GetBytes());
}

#ifdef SCREE_CAPTURE_NO_THREAD
struct Lock {
    explicit Lock(int) {}
};
#else
typedef std::unique_lock<std::mutex> Lock;
#endif

/// A file that gets steps and other payloads. Another thread packs and writes; `Push` never waits for it.
template <typename Api>
class TrackFile {
public:
    typedef std::unique_ptr<StepRecord<Api>> Record;

    TrackFile(const std::string& path, const Options& options)
        : m_memory(options.memory), m_maker(options), m_output(path), m_error(m_output.GetError()) {
#ifndef SCREE_CAPTURE_NO_THREAD
        if (m_error.empty()) m_thread = std::thread([this] { Run(); });
#endif
    }
    ~TrackFile() {
        End();
#ifndef SCREE_CAPTURE_NO_THREAD
        if (!m_thread.joinable()) return;
        {
            const Lock lock(m_mutex);
            m_isEnding = true;
        }
        m_changed.notify_all();
        m_thread.join();
#endif
    }
    TrackFile(const TrackFile&) = delete;
    TrackFile& operator=(const TrackFile&) = delete;

    /// Whether a step may be pushed: less than the memory waits, and nothing failed.
    bool HasRoom() {
        {
            const Lock lock(m_mutex);
            if (!m_error.empty()) return false;
            if (m_waiting + m_batchBytes < m_memory) return true;
        }
        HandOver();
        return false;
    }
    void Push(Record record) {
        // Batches end where all states are written anew, so that a crash loses no more steps than lie between.
        if (record->isKey) HandOver();
        m_batchBytes += record->CountBytes();
        m_batch.push_back(Job{Bytes(), std::move(record), false});
        if (m_batchBytes >= std::min(batchBytes, m_memory / 2)) HandOver();
    }
    /// A payload besides steps; it ends their block.
    void Push(Bytes payload) {
        m_batchBytes += payload.size();
        m_batch.push_back(Job{std::move(payload), Record(), false});
        HandOver();
    }
    /// A record to fill, with the memory of one that was written.
    Record TakeSpare() {
        if (m_spare.empty()) return Record(new StepRecord<Api>());
        Record record = std::move(m_spare.front());
        m_spare.pop_front();
        return record;
    }
    /// Returns once all is in the file.
    void Flush() {
        End();
#ifndef SCREE_CAPTURE_NO_THREAD
        Lock lock(m_mutex);
        if (m_thread.joinable()) m_changed.wait(lock, [this] { return m_waiting == 0; });
#endif
    }
    std::string GetError() {
        const Lock lock(m_mutex);
        return m_error;
    }

private:
    struct Job {
        Bytes payload;
        Record record;
        bool isEnd;  ///< of a block
    };

    void End() {
        ++m_batchBytes;
        m_batch.push_back(Job{Bytes(), Record(), true});
        HandOver();
    }
    /// Gives the batch to the thread.
    void HandOver() {
        if (m_batch.empty()) return;
        {
            const Lock lock(m_mutex);
            m_waiting += m_batchBytes;
            for (std::size_t i = 0; i < m_batch.size(); ++i) m_queue.push_back(std::move(m_batch[i]));
            for (std::size_t i = 0; i < m_used.size(); ++i) m_spare.push_back(std::move(m_used[i]));
            m_used.clear();
        }
        m_batch.clear();
        m_batchBytes = 0;
#ifdef SCREE_CAPTURE_NO_THREAD
        Work();
#else
        m_changed.notify_all();
#endif
    }

    /// Packs and writes what waits.
    void Work() {
        std::vector<Job> jobs;
        std::size_t bytes = 0;
        {
            const Lock lock(m_mutex);
            jobs.swap(m_queue);
            bytes = m_waiting;
        }
        for (std::size_t i = 0; i < jobs.size(); ++i) Do(jobs[i]);
        const Lock lock(m_mutex);
        m_waiting -= bytes;
        if (m_error.empty()) m_error = m_output.GetError();
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            if (jobs[i].record) m_used.push_back(std::move(jobs[i].record));
        }
    }
    void Do(Job& job) {
        if (!job.record || job.record->isKey) EndBlock();
        if (!job.record) {
            if (!job.isEnd) m_output.Append(job.payload, false);
            return;
        }
        m_maker.Add(*job.record);
        if (m_maker.IsFull()) EndBlock();
    }
    void EndBlock() {
        if (m_maker.IsEmpty()) return;
        Block block = m_maker.Take();
        m_output.Append(block.payload, true);
        m_maker.Reuse(std::move(block.payload));
    }

#ifdef SCREE_CAPTURE_NO_THREAD
    int m_mutex = 0;
#else
    void Run() {
        for (;;) {
            {
                Lock lock(m_mutex);
                m_changed.wait(lock, [this] { return m_isEnding || !m_queue.empty(); });
                if (m_queue.empty()) return;
            }
            Work();
            m_changed.notify_all();
        }
    }
    std::thread m_thread;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_isEnding = false;
#endif
    std::size_t m_memory, m_waiting = 0;
    std::vector<Job> m_queue;  ///< what waits for the thread
    std::vector<Record> m_used;
    // Of the thread that steps.
    std::vector<Job> m_batch;
    std::size_t m_batchBytes = 0;
    std::deque<Record> m_spare;  ///< the first is longest out of the sight of the thread that writes
    // Of the thread that writes.
    BlockMaker<Api> m_maker;
    Output m_output;
    std::string m_error;
};

}  // namespace detail
}  // namespace scree_capture
