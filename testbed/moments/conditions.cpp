// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The conditions of conditions.h that look at bodies, contacts and joints one by one.

#include "testbed/moments/conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "testbed/base/text.h"
#include "testbed/moments/lasting.h"

namespace testbed {
namespace {

bool IsFinite(const BodyState& b) {
    return std::isfinite(b.position.x) && std::isfinite(b.position.y) && std::isfinite(b.angle) &&
           std::isfinite(b.linearVelocity.x) && std::isfinite(b.linearVelocity.y) && std::isfinite(b.angularVelocity);
}

double LengthOf(Vec2 v) { return std::hypot(double{v.x}, double{v.y}); }

/// Something that is so of a body as it is: how large, negative: it is not so.
class BodyCondition final : public Condition {
public:
    using Measure = std::function<double(const BodyState&)>;
    BodyCondition(Lasting lasting, Measure measure) : m_lasting(std::move(lasting)), m_measure(std::move(measure)) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        for (const BodyState& body : frame.now.bodies) {
            const double size = m_measure(body);
            if (size >= 0.0) m_lasting.Note(frame, {body.index}, size);
        }
        m_lasting.EndStep(frame, found);
    }
    void AddOngoing(std::vector<Moment>& found) const override { m_lasting.AddOngoing(found); }
    void Finish(std::vector<Moment>& found) override { m_lasting.Finish(found); }

private:
    Lasting m_lasting;
    Measure m_measure;
};

/// Indices of the bodies of a contact in the scene, the smaller first.
std::pair<int, int> BodiesOf(const Snapshot& now, const ContactState& contact) {
    const auto indexOf = [&](int fixture) {
        const int place = now.fixtures[static_cast<std::size_t>(fixture)].body;
        return now.bodies[static_cast<std::size_t>(place)].index;
    };
    return std::minmax(indexOf(contact.fixtureA), indexOf(contact.fixtureB));
}

bool IsSolid(const Snapshot& now, const ContactState& contact) {
    return contact.touching && !now.fixtures[static_cast<std::size_t>(contact.fixtureA)].sensor &&
           !now.fixtures[static_cast<std::size_t>(contact.fixtureB)].sensor;
}

class Overlap final : public Condition {
public:
    Overlap(double depth, double longer)
        : m_depth(depth), m_lasting("overlap", "m", longer, [](double size) {
              return fmt::format("overlap by up to {:.4g} m", size);
          }) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        for (const ContactState& contact : frame.now.contacts) {
            if (!IsSolid(frame.now, contact)) continue;
            double depth = 0.0;
            for (int i = 0; i < contact.pointCount; ++i) depth = std::max(depth, -double{contact.separations[i]});
            if (depth <= m_depth) continue;
            const auto [a, b] = BodiesOf(frame.now, contact);
            m_lasting.Note(frame, {a, b}, depth);
        }
        m_lasting.EndStep(frame, found);
    }
    void AddOngoing(std::vector<Moment>& found) const override { m_lasting.AddOngoing(found); }
    void Finish(std::vector<Moment>& found) override { m_lasting.Finish(found); }

private:
    double m_depth;
    Lasting m_lasting;
};

class PileOn final : public Condition {
public:
    explicit PileOn(int contacts)
        : m_contacts(contacts), m_lasting("pile-on", "contacts", 0.0, [](double size) {
              return fmt::format("up to {:.0f} contacts", size);
          }) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        std::map<int, int> counts;
        for (const ContactState& contact : frame.now.contacts) {
            if (!contact.touching) continue;
            const auto [a, b] = BodiesOf(frame.now, contact);
            ++counts[a], ++counts[b];
        }
        for (const auto& [body, count] : counts) {
            const int place = frame.placeNow[static_cast<std::size_t>(body)];
            const bool isStatic = frame.now.bodies[static_cast<std::size_t>(place)].type == scenes::BodyType::isStatic;
            if (!isStatic && count > m_contacts) m_lasting.Note(frame, {body}, count);
        }
        m_lasting.EndStep(frame, found);
    }
    void AddOngoing(std::vector<Moment>& found) const override { m_lasting.AddOngoing(found); }
    void Finish(std::vector<Moment>& found) override { m_lasting.Finish(found); }

private:
    int m_contacts;
    Lasting m_lasting;
};

class Escape final : public Condition {
public:
    explicit Escape(const Box& box) : m_box(box) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        if (frame.before == nullptr) return;
        for (const BodyState& body : frame.now.bodies) {
            const int place = frame.placeBefore[static_cast<std::size_t>(body.index)];
            if (place < 0 || IsInside(body.position)) continue;
            if (!IsInside(frame.before->bodies[static_cast<std::size_t>(place)].position)) continue;
            const double speed = LengthOf(body.linearVelocity);
            found.push_back(
                {"escape",
                 frame.now.step,
                 frame.time,
                 frame.now.step,
                 {body.index},
                 speed,
                 "m/s",
                 fmt::format("left the box at {:.4g},{:.4g}, at {:.4g} m/s", body.position.x, body.position.y, speed)});
        }
    }
    void Finish(std::vector<Moment>&) override {}

private:
    [[nodiscard]] bool IsInside(Vec2 p) const {
        return p.x >= m_box.lower.x && p.x <= m_box.upper.x && p.y >= m_box.lower.y && p.y <= m_box.upper.y;
    }
    Box m_box;
};

class JointGap final : public Condition {
public:
    explicit JointGap(double gap)
        : m_gap(gap), m_lasting("joint-gap", "m", 0.0, [](double size) {
              return fmt::format("their joint is open by up to {:.4g} m", size);
          }) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        for (const JointState& joint : frame.now.joints) {
            if (joint.type != scenes::JointType::revolute && joint.type != scenes::JointType::weld) continue;
            const double gap = LengthOf({joint.anchorB.x - joint.anchorA.x, joint.anchorB.y - joint.anchorA.y});
            if (!(gap > m_gap)) continue;
            const auto indexOf = [&](int place) { return frame.now.bodies[static_cast<std::size_t>(place)].index; };
            m_lasting.Note(frame, {indexOf(joint.bodyA), indexOf(joint.bodyB)}, gap);
        }
        m_lasting.EndStep(frame, found);
    }
    void AddOngoing(std::vector<Moment>& found) const override { m_lasting.AddOngoing(found); }
    void Finish(std::vector<Moment>& found) override { m_lasting.Finish(found); }

private:
    double m_gap;
    Lasting m_lasting;
};

/// Largest side of the boxes of each body's fixtures, by index; of bodies that are new.
class Sizes {
public:
    void Update(const Frame& frame) {
        if (m_sizes.empty()) m_sizes.resize(frame.scene.bodies.size(), 0.0);
        for (const FixtureState& fixture : frame.now.fixtures) {
            const BodyState& body = frame.now.bodies[static_cast<std::size_t>(fixture.body)];
            const int place = frame.before == nullptr ? -1 : frame.placeBefore[static_cast<std::size_t>(body.index)];
            if (place >= 0) continue;
            double& size = m_sizes[static_cast<std::size_t>(body.index)];
            size = std::max({size, double{fixture.tight.upper.x} - fixture.tight.lower.x,
                             double{fixture.tight.upper.y} - fixture.tight.lower.y});
        }
    }
    [[nodiscard]] double Of(int body) const { return m_sizes[static_cast<std::size_t>(body)]; }

private:
    std::vector<double> m_sizes;
};

/// How far a body was in each direction.
struct Reach {
    Vec2 lower{}, upper{};

    void Begin(Vec2 p) { lower = upper = p; }
    void Add(Vec2 p) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    [[nodiscard]] double GetSize() const { return std::max(double{upper.x} - lower.x, double{upper.y} - lower.y); }
};

class Jitter final : public Condition {
public:
    void Look(const Frame& frame, std::vector<Moment>& found) override {
        m_sizes.Update(frame);
        for (const BodyState& body : frame.now.bodies) {
            const int place = frame.before == nullptr ? -1 : frame.placeBefore[static_cast<std::size_t>(body.index)];
            if (body.type != scenes::BodyType::dynamic || !body.awake || place < 0) {
                m_windows.erase(body.index);
                continue;
            }
            const Vec2 was = frame.before->bodies[static_cast<std::size_t>(place)].position;
            const Vec2 way{body.position.x - was.x, body.position.y - was.y};
            const auto [at, isNew] = m_windows.try_emplace(body.index);
            Window& window = at->second;
            if (isNew) window.Begin(frame, body.position);
            window.reach.Add(body.position);
            window.length += LengthOf(way);
            if (double{way.x} * window.way.x + double{way.y} * window.way.y < 0.0) ++window.turns;
            window.way = way;
            if (frame.time - window.time < 1.0) continue;
            const double speed = window.length / (frame.time - window.time);
            const bool stays = window.reach.GetSize() < 0.05 * m_sizes.Of(body.index);
            if (stays && window.turns >= 10 && speed > 0.01) Note(frame, body.index, window, speed);
            window.Begin(frame, body.position);
        }
        Close(frame, found);
    }
    void AddOngoing(std::vector<Moment>& found) const override {
        for (const auto& [body, moment] : m_open) found.push_back(moment);
    }
    void Finish(std::vector<Moment>& found) override {
        AddOngoing(found);
        m_open.clear();
    }

private:
    struct Window {
        int step = 0, turns = 0;
        double time = 0, length = 0;
        Reach reach;
        Vec2 way{};

        void Begin(const Frame& frame, Vec2 p) {
            *this = Window();
            step = frame.now.step;
            time = frame.time;
            reach.Begin(p);
        }
    };
    void Note(const Frame& frame, int body, const Window& window, double speed) {
        const auto [at, isNew] = m_open.try_emplace(body);
        Moment& moment = at->second;
        if (isNew) moment = {"jitter", window.step, window.time, 0, {body}, 0.0, "m/s", ""};
        moment.lastStep = frame.now.step;
        moment.size = std::max(moment.size, speed);
        moment.what = fmt::format("shakes where it is, at {:.4g} m/s", moment.size);
    }
    /// A window without shaking ends what was found before.
    void Close(const Frame& frame, std::vector<Moment>& found) {
        std::erase_if(m_open, [&](const auto& one) {
            const auto window = m_windows.find(one.first);
            const bool goesOn = window != m_windows.end() && window->second.step <= one.second.lastStep;
            if (goesOn || one.second.lastStep == frame.now.step) return false;
            found.push_back(one.second);
            return true;
        });
    }

    Sizes m_sizes;
    std::map<int, Window> m_windows;
    std::map<int, Moment> m_open;
};

class Awake final : public Condition {
public:
    explicit Awake(double seconds) : m_seconds(seconds) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        m_sizes.Update(frame);
        for (const BodyState& body : frame.now.bodies) {
            if (body.type != scenes::BodyType::dynamic) continue;
            const auto [at, isNew] = m_open.try_emplace(body.index);
            Stay& stay = at->second;
            Reach reach = stay.reach;
            reach.Add(body.position);
            if (isNew || !body.awake || !(reach.GetSize() <= m_sizes.Of(body.index))) {
                Add(body.index, stay, found);
                stay = {frame.now.step, frame.now.step, frame.time, frame.time, {}};
                stay.reach.Begin(body.position);
                continue;
            }
            stay.reach = reach;
            stay.lastStep = frame.now.step;
            stay.lastTime = frame.time;
        }
    }
    void AddOngoing(std::vector<Moment>& found) const override {
        for (const auto& [body, stay] : m_open) Add(body, stay, found);
    }
    void Finish(std::vector<Moment>& found) override {
        AddOngoing(found);
        m_open.clear();
    }

private:
    struct Stay {
        int step = 0, lastStep = 0;
        double time = 0, lastTime = 0;
        Reach reach;
    };
    void Add(int body, const Stay& stay, std::vector<Moment>& found) const {
        const double seconds = stay.lastTime - stay.time;
        if (seconds <= m_seconds) return;
        found.push_back({"awake",
                         stay.step,
                         stay.time,
                         stay.lastStep,
                         {body},
                         seconds,
                         "s",
                         fmt::format("stays awake for {:.4g} s without going anywhere", seconds)});
    }

    double m_seconds;
    Sizes m_sizes;
    std::map<int, Stay> m_open;
};

class Diverge final : public Condition {
public:
    Diverge(double distance, std::function<const Snapshot*(int)> other)
        : m_distance(distance), m_other(std::move(other)) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        if (m_isOver) return;
        const Snapshot* other = m_other(frame.now.step);
        m_isOver = other == nullptr;
        if (m_isOver) return;
        if (other->bodies.size() != frame.now.bodies.size()) {
            Add(frame, {}, 0.0, fmt::format("{} bodies here, {} there", frame.now.bodies.size(), other->bodies.size()),
                found);
            return;
        }
        double largest = -1.0;
        int body = -1;
        for (std::size_t i = 0; i < other->bodies.size(); ++i) {
            const BodyState &a = frame.now.bodies[i], &b = other->bodies[i];
            const double apart = LengthOf({b.position.x - a.position.x, b.position.y - a.position.y});
            const bool differs = m_distance > 0.0 ? !(apart <= m_distance)
                                                  : a.position != b.position || a.angle != b.angle ||
                                                        a.linearVelocity != b.linearVelocity ||
                                                        a.angularVelocity != b.angularVelocity;
            if (differs && !(apart <= largest)) largest = apart, body = a.index;
        }
        if (body >= 0) {
            Add(frame, {body}, largest, fmt::format("is {:.4g} m away from where it is in the other session", largest),
                found);
        }
    }
    void Finish(std::vector<Moment>&) override {}

private:
    void Add(const Frame& frame, std::vector<int> bodies, double size, std::string what, std::vector<Moment>& found) {
        found.push_back(
            {"diverge", frame.now.step, frame.time, frame.now.step, std::move(bodies), size, "m", std::move(what)});
        m_isOver = true;
    }

    double m_distance;
    std::function<const Snapshot*(int)> m_other;
    bool m_isOver = false;
};

class Marks final : public Condition {
public:
    explicit Marks(std::function<std::span<const std::string>(int)> marks) : m_marks(std::move(marks)) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        const int step = frame.now.step;
        for (const std::string& mark : m_marks(step)) {
            found.push_back({"mark", step, frame.time, step, {}, 0, "", ToPrintable(mark)});
        }
    }
    void Finish(std::vector<Moment>&) override {}

private:
    std::function<std::span<const std::string>(int)> m_marks;
};

}  // namespace

std::unique_ptr<Condition> MakeDivergeCondition(double distance, std::function<const Snapshot*(int)> other) {
    return std::make_unique<Diverge>(distance, std::move(other));
}

std::unique_ptr<Condition> MakeOverlapCondition(double depth, double longer) {
    return std::make_unique<Overlap>(depth, longer);
}

std::unique_ptr<Condition> MakeSpeedCondition(double speed) {
    return std::make_unique<BodyCondition>(
        Lasting("speed", "m/s", 0.0, [](double size) { return fmt::format("as fast as {:.4g} m/s", size); }),
        [speed](const BodyState& body) {
            const double is = LengthOf(body.linearVelocity);
            return is > speed ? is : -1.0;
        });
}

std::unique_ptr<Condition> MakeSpinCondition(double speed) {
    return std::make_unique<BodyCondition>(
        Lasting("spin", "rad/s", 0.0, [](double size) { return fmt::format("turns as fast as {:.4g} rad/s", size); }),
        [speed](const BodyState& body) {
            const double is = std::abs(double{body.angularVelocity});
            return is > speed ? is : -1.0;
        });
}

std::unique_ptr<Condition> MakeNonFiniteCondition() {
    return std::make_unique<BodyCondition>(
        Lasting("non-finite", "", 0.0, [](double) { return "has a pose or velocity that is not finite"; }),
        [](const BodyState& body) { return IsFinite(body) ? -1.0 : 0.0; });
}

std::unique_ptr<Condition> MakeEscapeCondition(const Box& box) { return std::make_unique<Escape>(box); }
std::unique_ptr<Condition> MakeJointGapCondition(double gap) { return std::make_unique<JointGap>(gap); }
std::unique_ptr<Condition> MakeJitterCondition() { return std::make_unique<Jitter>(); }
std::unique_ptr<Condition> MakeAwakeCondition(double seconds) { return std::make_unique<Awake>(seconds); }
std::unique_ptr<Condition> MakePileOnCondition(int contacts) { return std::make_unique<PileOn>(contacts); }

std::unique_ptr<Condition> MakeMarkCondition(std::function<std::span<const std::string>(int)> marks) {
    return std::make_unique<Marks>(std::move(marks));
}

}  // namespace testbed
