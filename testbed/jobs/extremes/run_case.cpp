// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of run_case.h.

#include "testbed/jobs/extremes/run_case.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <span>

#include "testbed/base/statistics.h"
#include "testbed/engines/measure.h"
#include "testbed/jobs/extremes/outline.h"

namespace testbed {

namespace {

constexpr double loadSeconds = 2.0;  ///< after which overlaps count
constexpr double restSeconds = 5.0;  ///< after which rest counts

double ReadProcessClock() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// One run of a case.
class Watcher {
public:
    Watcher(const ExtremeCase& one, const RunSpec& spec, double seconds)
        : m_case(one),
          m_seconds(seconds),
          m_timeStep(GetTimeStep(spec)),
          m_lab(MakeLab(one.make(), spec, {.restitutionThreshold = one.restitutionThreshold, .place = one.place})) {
        const scenes::Scene& scene = m_lab->GetScene();
        m_gravity = {double{scene.gravity.x}, double{scene.gravity.y}};
        for (int i = 0; i < m_lab->GetBodyCount(); ++i) m_extents.push_back(SmallestExtent(scene, i));
        m_bodies.resize(scene.bodies.size());
        Read();
        m_worst = m_bodies;
        m_startEnergy = SumEnergy(scene, m_bodies, m_gravity);
        m_energyScale = FindEnergyScale();
    }

    /// Until the end or `deadline` (of the process clock).
    void Run(double deadline) {
        while (m_outcome.seconds < m_seconds - 1e-9 && m_outcome.finite) {
            if (ReadProcessClock() > deadline) {
                m_outcome.shortened = true;
                break;
            }
            StepOnce();
        }
        if (m_outcome.finite) MeasureEnd();
    }

    [[nodiscard]] const Outcome& GetOutcome() const { return m_outcome; }
    [[nodiscard]] std::uint64_t GetHash() const { return m_lab->GetStateHash(); }
    [[nodiscard]] std::string DrawWorst() const { return DrawOutline(m_lab->GetScene(), m_worst); }

private:
    [[nodiscard]] bool IsDynamic(size_t i) const {
        return m_lab->GetScene().bodies[i].type == scenes::BodyType::dynamic;
    }

    void Read() {
        for (size_t i = 0; i < m_bodies.size(); ++i) m_bodies[i] = m_lab->Read(static_cast<int>(i));
    }

    /// What a rise of energy is measured by: motion and height of the start, and the height of a body. Where all that
    /// is nothing, it is the motion of bodies that nobody sees move.
    [[nodiscard]] double FindEnergyScale() const {
        const double unseen = 0.01 * m_case.scale;  // m/s
        double lowest = std::numeric_limits<double>::infinity(), kinetic = 0.0, height = 0.0;
        for (size_t i = 0; i < m_bodies.size(); ++i) {
            if (IsDynamic(i)) lowest = std::min(lowest, m_bodies[i].centre.y);
        }
        for (size_t i = 0; i < m_bodies.size(); ++i) {
            if (!IsDynamic(i)) continue;
            const BodyReading& b = m_bodies[i];
            kinetic +=
                0.5 * b.mass * (Dot(b.velocity, b.velocity) + unseen * unseen) + 0.5 * b.inertia * b.spin * b.spin;
            height += b.mass * Length(m_gravity) * (b.centre.y - lowest + m_case.scale);
        }
        return kinetic + height;
    }

    void StepOnce() {
        if (m_case.disturb) m_case.disturb(*m_lab, m_outcome.steps);
        const double dt = m_case.stepLength ? m_case.stepLength(m_outcome.steps) : m_timeStep;
        const StepFacts facts = m_lab->Step(dt);
        ++m_outcome.steps;
        // A step of no length counts as a 60th, so that a case of such steps ends.
        m_outcome.seconds += dt > 0.0 ? dt : 1.0 / 60.0;
        m_outcome.milliseconds = std::max(m_outcome.milliseconds, facts.milliseconds);
        m_outcome.contacts = std::max(m_outcome.contacts, facts.contacts);
        m_outcome.capped += facts.capped;
        m_outcome.stopped += facts.nonFinite;
        m_work.push_back(static_cast<double>(facts.contacts) + static_cast<double>(std::max<int64_t>(0, facts.pairs)));
        Read();
        Judge();
    }

    /// Keeps the moment of the worst fault, in units of what is asked.
    void KeepWorst(double fault) {
        if (fault <= m_worstFault) return;
        m_worstFault = fault;
        m_worst = m_bodies;
        m_outcome.worstStep = m_outcome.steps;
    }

    void Judge() {
        int escapes = 0;
        for (size_t i = 0; i < m_bodies.size(); ++i) {
            if (!m_bodies[i].IsFinite()) {
                m_outcome.finite = false;
                m_outcome.worstStep = m_outcome.steps;
                return;
            }
            if (!IsDynamic(i)) continue;
            m_outcome.maxSpeed = std::max(m_outcome.maxSpeed, Length(m_bodies[i].velocity));
            if (const auto& bounds = m_case.demands.bounds) {
                const Point p = m_bodies[i].centre;
                escapes +=
                    p.x < bounds->lower.x || p.x > bounds->upper.x || p.y < bounds->lower.y || p.y > bounds->upper.y;
            }
        }
        m_outcome.escapes = std::max(m_outcome.escapes, escapes);
        const double gain = (SumEnergy(m_lab->GetScene(), m_bodies, m_gravity) - m_startEnergy) / m_energyScale;
        m_outcome.gain = std::max(m_outcome.gain, gain);
        KeepWorst(std::max(m_case.demands.energy ? gain : 0.0, escapes > 0 ? 1.0 + escapes : 0.0));
        JudgeJoints();
        // Overlaps are a walk over all contacts: not in every step.
        if (m_outcome.seconds >= std::min(loadSeconds, 0.5 * m_seconds) && m_outcome.steps % 6 == 0) JudgeOverlap();
    }

    void JudgeJoints() {
        const auto& joints = m_lab->GetScene().joints;
        if (joints.size() > 3000 && m_outcome.steps % 6 != 0) return;
        for (const scenes::Joint& j : joints) {
            if (j.type != scenes::JointType::revolute) continue;
            const auto at = [this](int body, scenes::Vec2 local) {
                return m_bodies[static_cast<size_t>(body)].ToWorld({double{local.x}, double{local.y}});
            };
            const double gap = Length(at(j.bodyA, j.localAnchorA) - at(j.bodyB, j.localAnchorB));
            m_outcome.jointGap = std::max(m_outcome.jointGap, gap);
        }
        KeepWorst(m_outcome.jointGap / m_case.scale);
    }

    void JudgeOverlap() {
        m_lab->GetContacts(m_contacts);
        for (const ContactReading& c : m_contacts) {
            const double extent =
                std::min(m_extents[static_cast<size_t>(c.bodyA)], m_extents[static_cast<size_t>(c.bodyB)]);
            for (int p = 0; p < c.pointCount; ++p) {
                const double overlap = -c.separations[p];
                m_outcome.overlap = std::max(m_outcome.overlap, overlap);
                m_outcome.overlapShare = std::max(m_outcome.overlapShare, overlap / extent);
            }
        }
        KeepWorst(m_outcome.overlapShare);
    }

    [[nodiscard]] std::vector<bool> FindJoined() const {
        std::vector<bool> isJoined(m_bodies.size());
        for (const scenes::Joint& joint : m_lab->GetScene().joints) {
            isJoined[static_cast<size_t>(joint.bodyA)] = isJoined[static_cast<size_t>(joint.bodyB)] = true;
        }
        return isJoined;
    }

    void MeasureEnd() {
        const bool isRestDue = m_seconds >= std::min(m_case.seconds, restSeconds);  // not in a quick form
        if (m_case.demands.restSpeed > 0.0 && !m_outcome.shortened && isRestDue) {
            const std::vector<bool> isJoined = FindJoined();
            m_outcome.restSpeed = 0.0;
            for (size_t i = 0; i < m_bodies.size(); ++i) {
                if (m_case.demands.restOfLoose && isJoined[i]) continue;
                if (IsDynamic(i)) m_outcome.restSpeed = std::max(m_outcome.restSpeed, Length(m_bodies[i].velocity));
            }
        }
        if (m_case.measure) m_outcome.accuracy = m_case.measure(*m_lab, m_outcome.seconds);
        const std::span<const double> last = std::span<const double>(m_work).subspan(2 * m_work.size() / 3);
        if (last.empty()) return;
        // Below a few dozen contacts a ratio says nothing.
        const double usual = std::max(Quantile(last, 0.5), 50.0);
        m_outcome.workRatio = std::max(1.0, *std::ranges::max_element(m_work) / usual);
    }

    const ExtremeCase& m_case;
    double m_seconds, m_timeStep;
    std::unique_ptr<LabWorld> m_lab;
    Point m_gravity;
    std::vector<double> m_extents;  ///< by body
    std::vector<BodyReading> m_bodies, m_worst;
    std::vector<ContactReading> m_contacts;
    std::vector<double> m_work;  ///< by step
    double m_startEnergy = 0.0, m_energyScale = 1.0, m_worstFault = 0.0;
    Outcome m_outcome;
};

CaseRun RunAbuseCase(const ExtremeCase& one, const RunSpec& setting) {
    const AbuseResult result = RunAbuse(setting, *one.abuse);
    Outcome o;
    o.finite = result.finite;
    o.badCalls = result.calls;
    o.refused = result.refused;
    o.named = result.named;
    o.changed = result.changed;
    o.replaced = result.replaced;
    o.note = result.note;
    return {o, {}};
}

}  // namespace

double SmallestExtent(const scenes::Scene& scene, int body) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const scenes::Fixture& f : scene.FixturesOf(body)) {
        switch (f.shape.type) {
            case scenes::ShapeType::circle:
                smallest = std::min(smallest, 2.0 * double{f.shape.radius});
                break;
            case scenes::ShapeType::box:
                smallest = std::min(smallest, 2.0 * double{std::min(f.shape.halfExtents.x, f.shape.halfExtents.y)});
                break;
            case scenes::ShapeType::polygon: {
                double left = 1e30, right = -1e30, low = 1e30, high = -1e30;
                for (const scenes::Vec2 v : f.shape.Vertices()) {
                    left = std::min(left, double{v.x});
                    right = std::max(right, double{v.x});
                    low = std::min(low, double{v.y});
                    high = std::max(high, double{v.y});
                }
                smallest = std::min(smallest, std::min(right - left, high - low));
                break;
            }
            default:
                break;  // edges and chains have no inside
        }
    }
    return smallest;
}

double SumEnergy(const scenes::Scene& scene, std::span<const BodyReading> bodies, Point pull) {
    double sum = 0.0;
    for (size_t i = 0; i < bodies.size(); ++i) {
        if (scene.bodies[i].type != scenes::BodyType::dynamic) continue;
        const BodyReading& b = bodies[i];
        const double scale = double{scene.bodies[i].gravityScale};
        sum += 0.5 * b.mass * Dot(b.velocity, b.velocity) + 0.5 * b.inertia * b.spin * b.spin -
               scale * b.mass * Dot(pull, b.centre);
    }
    return sum;
}

CaseRun RunCase(const ExtremeCase& one, const RunSpec& setting, const CaseBudget& budget) {
    if (one.prepare) one.prepare();
    if (one.abuse) return RunAbuseCase(one, setting);
    const double start = ReadProcessClock();
    const double seconds = budget.quick ? std::min(one.seconds, one.quickSeconds) : one.seconds;
    CaseRun run;
    try {
        RunSpec spec = setting;
        ApplySettings(spec, one.settings);
        Watcher first(one, spec, seconds);
        first.Run(start + budget.cpuSeconds);
        run.outcome = first.GetOutcome();
        run.picture = first.DrawWorst();
        const double used = ReadProcessClock() - start;
        if (budget.repeats && run.outcome.finite && !run.outcome.shortened && used < 0.4 * budget.cpuSeconds) {
            spec.threads = spec.threads == 2 ? 1 : 2;  // where the engine has them
            Watcher second(one, spec, seconds);
            second.Run(start + budget.cpuSeconds);
            if (!second.GetOutcome().shortened) run.outcome.repeated = first.GetHash() == second.GetHash();
        }
    } catch (const std::invalid_argument& refusal) {
        run.outcome.refusal = refusal.what();
    }
    return run;
}

}  // namespace testbed
