// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of outcome.h.

#include "testbed/jobs/extremes/outcome.h"
#include "testbed/base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace testbed {

namespace {

/// Gains of energy above the first are errors, above the second explosions.
constexpr double errorGain = 0.01, explosionGain = 1.0;
/// A step may do this many times the work of the median one.
constexpr double mostWork = 50.0;

/// Calls `visit(name, member)` for every field of an outcome.
template <class Outcome, class Visit>
void VisitFields(Outcome& o, Visit&& visit) {
    visit("steps", o.steps);
    visit("seconds", o.seconds);
    visit("shortened", o.shortened);
    visit("finite", o.finite);
    visit("refusal", o.refusal);
    visit("gain", o.gain);
    visit("escapes", o.escapes);
    visit("maxSpeed", o.maxSpeed);
    visit("overlapShare", o.overlapShare);
    visit("overlap", o.overlap);
    visit("jointGap", o.jointGap);
    visit("restSpeed", o.restSpeed);
    visit("accuracy", o.accuracy);
    visit("contacts", o.contacts);
    visit("workRatio", o.workRatio);
    visit("capped", o.capped);
    visit("stopped", o.stopped);
    visit("repeated", o.repeated);
    visit("worstStep", o.worstStep);
    visit("badCalls", o.badCalls);
    visit("refused", o.refused);
    visit("named", o.named);
    visit("changed", o.changed);
    visit("replaced", o.replaced);
    visit("note", o.note);
    visit("ms", o.milliseconds);
}

std::string DescribeEnding(const Ending& ending) {
    if (ending.timedOut) return "over the time limit: stopped";
    if (ending.signal != 0) return fmt::format("ended by signal {} ({})", ending.signal, strsignal(ending.signal));
    return fmt::format("ended with exit code {} and told nothing", ending.exitCode);
}

void GradeAbuse(const ExtremeCase& one, const Outcome& o, CaseGrade& verdict) {
    const bool isInput = *one.abuse == Abuse::nonFiniteBody || *one.abuse == Abuse::nonFiniteFixture ||
                         *one.abuse == Abuse::nonFiniteJoint || *one.abuse == Abuse::nonFiniteQuery ||
                         *one.abuse == Abuse::nonFiniteStep || *one.abuse == Abuse::badPolygons ||
                         *one.abuse == Abuse::badDensity || *one.abuse == Abuse::destroyInCallback;
    const auto fault = [&](bool is, const std::string& reason) {
        if (is) verdict.reasons.push_back(reason);
    };
    fault(o.changed, o.note.empty() ? "a refused call changed the world" : o.note);
    fault(o.replaced, o.note);
    if (!isInput) return;
    const bool partly = *one.abuse == Abuse::badPolygons || *one.abuse == Abuse::badDensity;  // some of them are legal
    fault(!partly && o.refused < o.badCalls,
          fmt::format("{} of {} bad calls refused; {}", o.refused, o.badCalls, o.note));
    fault(o.named < o.refused, fmt::format("{} of {} errors name the field", o.named, o.refused));
}

}  // namespace

nlohmann::ordered_json ToJson(const Outcome& outcome) {
    nlohmann::ordered_json fields;
    VisitFields(outcome, [&](const char* name, const auto& value) { fields[name] = value; });
    return fields;
}

Outcome OutcomeFromJson(const nlohmann::ordered_json& fields) {
    Outcome outcome;
    try {
        VisitFields(outcome, [&](const char* name, auto& value) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
                const bool isFinite = !fields.at(name).is_null();
                value = isFinite ? fields.at(name).template get<double>() : std::numeric_limits<double>::infinity();
            } else {
                fields.at(name).get_to(value);
            }
        });
    } catch (const nlohmann::json::exception& error) {
        throw FileError(std::string("a field is missing or of another kind: ") + error.what());
    }
    return outcome;
}

std::string NameGrade(Grade grade) {
    switch (grade) {
        case Grade::notFinished:
            return "not finished";
        case Grade::abort:
            return "aborts or hangs";
        case Grade::nonFinite:
            return "non-finite";
        case Grade::explodes:
            return "explodes, escapes or is refused";
        case Grade::survives:
            return "survives with an error";
        case Grade::accurate:
            break;
    }
    return "as asked";
}

std::string PrintGrade(Grade grade) {
    return grade == Grade::notFinished ? "" : fmt::format("{}", static_cast<int>(grade));
}

CaseGrade GradeCase(const ExtremeCase& one, const Ending& ending, const Outcome& o) {
    if (ending.timedOut || ending.signal != 0 || ending.exitCode != 0 || !ending.output) {
        return {Grade::abort, {DescribeEnding(ending)}};
    }
    if (!o.finite) {
        return {Grade::nonFinite,
                {one.abuse ? o.note : fmt::format("a state is not finite after step {}", o.worstStep)}};
    }
    const Demands& d = one.demands;
    CaseGrade verdict;
    // A demand is met by numbers that are at most its own; what is no number meets none.
    const auto exceeds = [](double value, double limit) { return !(value <= limit); };
    if (!o.refusal.empty()) {
        verdict = {Grade::explodes, {"refused: " + o.refusal}};
    } else if (d.bounds && o.escapes > 0) {
        verdict = {Grade::explodes, {fmt::format("{} bodies escape", o.escapes)}};
    } else if (d.energy && exceeds(o.gain, explosionGain)) {
        verdict = {Grade::explodes, {fmt::format("energy rises by {:.3g} times that of the start", o.gain)}};
    } else if (d.maxSpeed > 0.0 && exceeds(o.maxSpeed, d.maxSpeed)) {
        verdict = {Grade::explodes, {fmt::format("a body reaches {:.3g} m/s", o.maxSpeed)}};
    }
    const bool exploded = verdict.grade == Grade::explodes;
    const auto fault = [&](bool is, const std::string& reason) {
        if (is) verdict.reasons.push_back(reason);
    };
    fault(!exploded && d.energy && exceeds(o.gain, errorGain), fmt::format("energy rises by {:.3g} %", 100.0 * o.gain));
    fault(d.overlapShare > 0.0 && exceeds(o.overlapShare, d.overlapShare),
          fmt::format("bodies overlap by {:.3g} % of their size", 100.0 * o.overlapShare));
    fault(d.overlap > 0.0 && exceeds(o.overlap, d.overlap),
          fmt::format("overlap {:.3g} m, asked {:.3g}", o.overlap, d.overlap));
    fault(d.jointGap > 0.0 && exceeds(o.jointGap, d.jointGap),
          fmt::format("a joint opens by {:.3g} m, asked {:.3g}", o.jointGap, d.jointGap));
    fault(d.restSpeed > 0.0 && exceeds(o.restSpeed, d.restSpeed),
          fmt::format("not at rest: {:.3g} m/s, asked {:.3g}", o.restSpeed, d.restSpeed));
    fault(d.accuracy > 0.0 && exceeds(o.accuracy, d.accuracy),
          fmt::format("error {:.3g}, asked {:.3g}", o.accuracy, d.accuracy));
    fault(exceeds(o.workRatio, mostWork),
          fmt::format("a step does {:.0f} times the work of the median one", o.workRatio));
    fault(o.repeated == 0, "a second run ends in other states");
    fault(o.capped > 0, fmt::format("speed was capped {} times", o.capped));
    fault(o.stopped > 0, fmt::format("{} bodies were stopped because they became non-finite", o.stopped));
    if (one.abuse) GradeAbuse(one, o, verdict);
    if (exploded) return verdict;
    if (!verdict.reasons.empty()) verdict.grade = Grade::survives;
    if (o.shortened) {
        verdict.grade = Grade::notFinished;
        verdict.reasons.insert(verdict.reasons.begin(), fmt::format("the time was over after {:.3g} s", o.seconds));
    }
    return verdict;
}

}  // namespace testbed
