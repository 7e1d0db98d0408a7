// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of joints: what all have in common, a dense table per type, and which joints hang on which body. Adding,
// removing and walking to the next joint of a body are O(1).

#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "base/index_set.h"
#include "base/slots.h"
#include "scree/body.h"
#include "state/joint_rows.h"

namespace scree {

/// Neighbours in the list of one body's joints. A joint stands in two lists, so an entry is 2·joint + side (0: body A,
/// 1: body B); −1 is the end.
struct JointLink {
    int prev = -1, next = -1;
};

/// What every joint has.
struct JointInfo {
    JointType type = e_unknownJoint;
    bool collideConnected = false;
    BodyIndex bodyA = BodyIndex::none, bodyB = BodyIndex::none;
    JointRow row = JointRow::none;  ///< in the table of its type
    int gearCount = 0;              ///< gears that use this joint
    JointIndex listPrev = JointIndex::none, listNext = JointIndex::none;
    JointLink link[2];  ///< in the lists of body A and body B
    float forceThreshold = std::numeric_limits<float>::infinity();
    float torqueThreshold = std::numeric_limits<float>::infinity();
    bool breaks = false;  ///< beyond a threshold
    JointUserData userData;

    [[nodiscard]] bool HasThreshold() const {
        constexpr float none = std::numeric_limits<float>::infinity();
        return forceThreshold < none || torqueThreshold < none;
    }
};

/// Rows and handles of one type. Rows and handles are used again, never given back, so a pointer to a destroyed joint
/// still points at a handle.
template <typename Row>
struct JointStore {
    using RowType = Row;
    Slots<JointRow> slots;
    Column<JointRow, Row> rows;
    StableColumn<JointRow, typename Row::Handle> handles;

    template <typename Self, typename Visit>
    static void Fields(Self& store, Visit& visit) {
        auto& [slots, rows, handles] = store;
        visit(slots), visit.Rows(slots, rows), visit.LeftOut(handles);
    }
};

/// The parts of an entry.
constexpr JointIndex JointOf(int entry) { return JointIndex{entry >> 1}; }
constexpr int SideOf(int entry) { return entry & 1; }
constexpr int EntryOf(JointIndex joint, int side) { return 2 * ToInt(joint) + side; }

/// The joints of one body, newest first.
class BodyJoints {
public:
    class Iterator {
    public:
        Iterator(const Column<JointIndex, JointInfo>& info, int entry) : m_info(&info), m_entry(entry) {}
        JointIndex operator*() const { return JointOf(m_entry); }
        Iterator& operator++() {
            m_entry = (*m_info)[**this].link[SideOf(m_entry)].next;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return m_entry != other.m_entry; }

    private:
        const Column<JointIndex, JointInfo>* m_info;
        int m_entry;
    };

    BodyJoints(const Column<JointIndex, JointInfo>& info, int head) : m_info(info), m_head(head) {}
    [[nodiscard]] Iterator begin() const { return {m_info, m_head}; }
    [[nodiscard]] Iterator end() const { return {m_info, -1}; }
    [[nodiscard]] bool empty() const { return m_head < 0; }
    /// The newest joint, −1 if there is none.
    [[nodiscard]] JointIndex Front() const { return JointOf(m_head); }

private:
    const Column<JointIndex, JointInfo>& m_info;
    int m_head;
};

template <typename... Row>
using JointStores = std::tuple<JointStore<Row>...>;

struct JointTable {
    Slots<JointIndex> slots;
    Column<JointIndex, JointInfo> info;
    Column<JointIndex, Joint*> handles;
    /// One table per type.
    OfJointTypes<JointStores> stores;
    JointIndex listHead = JointIndex::none;
    IndexSet<JointIndex> watched;  ///< joints with a threshold

    template <typename Row>
    [[nodiscard]] JointStore<Row>& Store() {
        return std::get<JointStore<Row>>(stores);
    }
    template <typename Row>
    [[nodiscard]] const JointStore<Row>& Store() const {
        return std::get<JointStore<Row>>(stores);
    }
    /// Calls visit(store) for the table of one type; not at all for a type without one.
    template <typename Self, typename Visit>
    static void WithStore(Self& self, JointType type, Visit&& visit) {
        std::apply(
            [&](auto&... store) {
                ((std::remove_reference_t<decltype(store)>::RowType::type == type ? visit(store) : void()), ...);
            },
            self.stores);
    }

    /// Adds a joint with the bodies, type, flag and user data of `head`; everything else of it is set here.
    template <typename Row>
    JointIndex Add(WorldState* state, const JointInfo& head, const Row& row) {
        JointStore<Row>& store = Store<Row>();
        const JointRow rowIndex = store.slots.Prepare();
        const JointIndex index = slots.Prepare();
        // When memory runs out nothing has changed yet.
        ReserveRows(ToSize(rowIndex) + 1, store.rows);
        ReserveRows(ToSize(index) + 1, info, handles, m_births);
        watched.Reserve(ToSize(index) + 1);
        ReserveRows(ToSize(std::max(head.bodyA, head.bodyB)) + 1, m_first, m_count);
        if (rowIndex == store.handles.End()) store.handles.emplace_back(state, JointIndex::none, rowIndex);

        store.slots.Allocate();
        slots.Allocate();
        EnsureRow(store.rows, rowIndex);
        store.rows[rowIndex] = row;
        Joint& handle = store.handles[rowIndex];
        handle.m_index = index;
        Link(index, rowIndex, head, &handle);
        return index;
    }
    void Remove(JointIndex joint);
    /// Makes others the bodies of a joint, two different ones.
    void SetBodies(JointIndex joint, BodyIndex bodyA, BodyIndex bodyB);

    /// Whether `a` stands before `b` in the list.
    [[nodiscard]] bool IsNewer(JointIndex a, JointIndex b) const { return m_births[a] > m_births[b]; }
    /// How many joints there have been.
    [[nodiscard]] int64_t GetBirths() const { return m_nextBirth; }
    [[nodiscard]] BodyJoints OfBody(BodyIndex body) const { return {info, m_first.Has(body) ? m_first[body] : -1}; }
    /// The joint after `joint` in the list of one of its bodies; −1 at the end.
    [[nodiscard]] JointIndex NextOfBody(JointIndex joint, BodyIndex body) const;
    /// False if a joint forbids the two bodies to collide.
    [[nodiscard]] bool MayCollide(BodyIndex bodyA, BodyIndex bodyB) const;
    /// The lists of the bodies and everything a joint has; the rows of each type are in the stores.
    template <typename Self, typename Visit>
    static void Fields(Self& t, Visit& visit) {
        auto& [slots, info, handles, stores, listHead, watched, first, count, births, nextBirth] = t;
        visit(slots), visit.Rows(slots, info), visit(listHead, first, count);
        std::apply([&](auto&... store) { visit(store...); }, stores);
        visit.LeftOut(handles, watched, births, nextBirth);
    }
    /// After its thresholds changed.
    void NoteThresholds(JointIndex joint) { info[joint].HasThreshold() ? watched.Insert(joint) : watched.Erase(joint); }
    /// After the fields were read: makes the handles. False if the fields contradict each other; that bodies exist is
    /// not checked, bodyCount only bounds them.
    [[nodiscard]] bool Restore(WorldState* state, int bodyCount);
    /// Takes over the handles of a table that this one is to replace: a joint has the handle of its row there.
    void TakeHandles(WorldState* state, JointTable& old);
    /// Moves what joints keep in world coordinates.
    void ShiftOrigin(Vec2 newOrigin);
    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    void Link(JointIndex joint, JointRow row, const JointInfo& head, Joint* handle);
    void LinkToBody(JointIndex joint, int side);
    void UnlinkFromBody(JointIndex joint, int side);
    [[nodiscard]] bool RestoreHandles(WorldState* state);
    [[nodiscard]] bool AreListsWhole() const;
    void CountBirths();

    Column<BodyIndex, int> m_first;        ///< per body: its newest entry
    Column<BodyIndex, int> m_count;        ///< per body: entries
    Column<JointIndex, int64_t> m_births;  ///< larger for those that stand before others in the list
    int64_t m_nextBirth = 0;
};

}  // namespace scree
