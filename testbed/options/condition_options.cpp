// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of condition_options.h.

#include "testbed/options/condition_options.h"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/text.h"
#include "testbed/input/file_kind.h"
#include "testbed/input/track_file.h"
#include "testbed/moments/conditions.h"
#include "testbed/options/options.h"

namespace testbed {

namespace {

Box ParseBox(const std::string& text) {
    std::vector<float> numbers;
    for (const std::string_view part : Split(text, ',')) {
        const Parsed<double> number = ParseNumber<double>(part);
        if (!number) break;
        numbers.push_back(static_cast<float>(*number));
    }
    if (numbers.size() != 4 || numbers[0] > numbers[2] || numbers[1] > numbers[3]) {
        throw UsageError(
            fmt::format("--escape {}: give left,bottom,right,top in metres, for example --escape=-20,-1,20,30", text));
    }
    return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

/// The other side of --diverge: a file, or an engine that runs the same.
struct Other {
    std::unique_ptr<Session> session;
    Snapshot state;

    const Snapshot* After(int step) {
        while (session->GetStep() < step) {
            if (!session->Step()) return nullptr;
        }
        state = session->Capture();
        return &state;
    }
};

std::shared_ptr<Other> MakeOther(const ConditionArguments& arguments, SessionArguments there, const SceneInput& input) {
    auto other = std::make_shared<Other>();
    if (LooksLikeFile(arguments.diverge)) {
        there.input = arguments.diverge;
        there.size.reset();
        if (input.motion != nullptr) there.steps.clear();  // it is as long as it is
        other->session = std::make_unique<Session>(OpenSession(there, ChooseSessionInput(there)));
        return other;
    }
    if (input.motion != nullptr) {
        throw UsageError(
            fmt::format("--diverge {}: {} is a motion, and --from K says where an engine starts in it; "
                        "give another file",
                        arguments.diverge, there.input));
    }
    there.engine = arguments.diverge;
    other->session = std::make_unique<Session>(OpenSession(there, input));
    return other;
}

struct Asked : AskedConditions {
    bool needsContacts = false, needsTimes = false;

    void Add(const std::string& name, std::unique_ptr<Condition> condition) {
        names.push_back(name);
        conditions.push_back(std::move(condition));
    }
};

std::unique_ptr<Condition> MakeMarks(const SceneInput& input) {
    return MakeMarkCondition([track = input.motion](int step) { return std::span(track->Read(step).marks); });
}

/// Expressions, numbered where there are several.
void AddExpressions(const std::vector<std::string>& texts, const WatchedFacts& facts, Asked& asked) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        try {
            Expression expression(texts[i], facts.names);
            asked.needsContacts = asked.needsContacts || expression.NeedsContacts();
            const std::string name = texts.size() == 1 ? "when" : fmt::format("when-{}", i + 1);
            asked.Add(name, MakeWhenCondition(name, std::move(expression)));
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("--when '{}': {}", texts[i], error.what()));
        }
    }
}

void CheckHas(const WatchedFacts& facts, const Asked& asked, const std::string& input) {
    constexpr const char* cure = "record it with scree_capture::Options::{} = true, or give --from K to run an engine";
    if (asked.needsContacts && !facts.hasContacts) {
        throw UsageError(
            fmt::format("{} was recorded without contacts, which --overlap, --pile-on and contacts in --when need; {}",
                        input, fmt::format(fmt::runtime(cure), "contacts")));
    }
    if (asked.needsTimes && !facts.hasTimes) {
        throw UsageError(fmt::format("{} was recorded without times, which --spike needs; {}", input,
                                     fmt::format(fmt::runtime(cure), "stages")));
    }
}

}  // namespace

AskedConditions MakeConditions(const ConditionArguments& a, const SessionArguments& opened, const SceneInput& input,
                               const Session& session) {
    return MakeConditions(a, opened, input, {session.GetNames(), session.HasContacts(), session.HasTimes()});
}

AskedConditions MakeConditionsAndMarks(const ConditionArguments& a, const SessionArguments& opened,
                                       const SceneInput& input, const Session& session) {
    AskedConditions asked = MakeConditions(a, opened, input, session);
    if (a.marks || input.motion == nullptr || input.motion->GetInfo().marks == 0) return asked;
    asked.names.emplace_back("mark");
    asked.conditions.push_back(MakeMarks(input));
    return asked;
}

bool IsAnyAsked(const ConditionArguments& a) {
    return a.tunnel || a.marks || a.overlap || a.speed || a.spin || a.nonFinite || !a.escape.empty() || a.spike ||
           a.jointGap || a.jitter || a.awake || a.pileOn || !a.diverge.empty() || !a.when.empty();
}

AskedConditions MakeConditions(const ConditionArguments& a, const SessionArguments& opened, const SceneInput& input,
                               const WatchedFacts& facts) {
    Asked asked;
    asked.needsContacts = a.overlap || a.pileOn;
    asked.needsTimes = a.spike.has_value();
    if (a.tunnel) asked.Add("tunnel", MakeTunnelCondition());
    if (a.overlap) asked.Add("overlap", MakeOverlapCondition(*a.overlap, a.longer));
    if (a.speed) asked.Add("speed", MakeSpeedCondition(*a.speed));
    if (a.spin) asked.Add("spin", MakeSpinCondition(*a.spin));
    if (a.nonFinite) asked.Add("non-finite", MakeNonFiniteCondition());
    if (!a.escape.empty()) asked.Add("escape", MakeEscapeCondition(ParseBox(a.escape)));
    if (a.spike) asked.Add("spike", MakeSpikeCondition(*a.spike, facts.hasContacts));
    if (a.jointGap) asked.Add("joint-gap", MakeJointGapCondition(*a.jointGap));
    if (a.jitter) asked.Add("jitter", MakeJitterCondition());
    if (a.awake) asked.Add("awake", MakeAwakeCondition(*a.awake));
    if (a.pileOn) asked.Add("pile-on", MakePileOnCondition(*a.pileOn));
    if (!a.diverge.empty()) {
        asked.Add("diverge", MakeDivergeCondition(a.distance, [other = MakeOther(a, opened, input)](int step) {
                      return other->After(step);
                  }));
    }
    if (a.marks) {
        if (input.motion == nullptr) {
            throw UsageError(
                fmt::format("--marks: {} has none; they stand in a motion that a program recorded with "
                            "Track::Mark",
                            opened.input));
        }
        asked.Add("mark", MakeMarks(input));
    }
    AddExpressions(a.when, facts, asked);
    if (asked.names.empty()) {
        asked.Add("tunnel", MakeTunnelCondition());
        asked.Add("non-finite", MakeNonFiniteCondition());
    }
    CheckHas(facts, asked, opened.input);
    return std::move(static_cast<AskedConditions&>(asked));
}

void AddConditionOptions(CLI::App& app, ConditionArguments& a, const std::string& group) {
    const auto number = [&](const char* name, std::optional<double>& value, const char* what, const char* type) {
        app.add_option(name, value, what)->type_name(type)->check(ZeroOrAbove())->group(group);
    };
    app.add_flag("--tunnel", a.tunnel, "A body that went through a static shape and was not pushed out")->group(group);
    number("--overlap", a.overlap, "Two bodies deeper in each other than this, m", "M");
    app.add_option("--longer", a.longer, "With --overlap: for longer than this, s; 0 if not given")
        ->check(ZeroOrAbove())
        ->needs(app.get_option("--overlap"))
        ->group(group);
    number("--speed", a.speed, "A body faster than this, m/s", "V");
    number("--spin", a.spin, "A body that turns faster than this, rad/s", "W");
    app.add_flag("--non-finite", a.nonFinite, "A body whose pose or velocity is NaN or infinite")->group(group);
    app.add_option("--escape", a.escape, "A body that leaves the box left,bottom,right,top: --escape=-20,-1,20,30")
        ->type_name("BOX")
        ->group(group);
    number("--spike", a.spike,
           "A step that takes this many times the median: with the stage that grew most and the bodies with the most "
           "new pairs, the largest box and the most contacts, as far as they are known",
           "F");
    number("--joint-gap", a.jointGap, "A revolute or weld joint open by more than this, m", "M");
    app.add_flag("--jitter", a.jitter, "A body that stays where it is and yet shakes")->group(group);
    number("--awake", a.awake, "A body that is awake for longer than this and goes nowhere, s", "S");
    app.add_option("--pile-on", a.pileOn, "A body that moves, with more than this many contacts")
        ->type_name("N")
        ->check(ZeroOrAbove())
        ->group(group);
    app.add_flag("--marks", a.marks, "Texts that the program left in a track with Track::Mark")->group(group);
    app.add_option("--when", a.when,
                   "Steps after which this holds, by names or indices of bodies (in a name \\\" is a quote and \\\\ a "
                   "backslash): 'body(\"player\").y < -5 and not "
                   "body(\"player\").awake', 'contacts(\"player\", \"lava\") > 0'; repeatable")
        ->type_name("EXPR")
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--diverge", a.diverge, "The first step that differs from that of another file or engine")
        ->type_name("FILE|ENGINE[:KEY=VALUE]")
        ->group(group);
    app.add_option("--distance", a.distance,
                   "With --diverge: a difference is more than this, m; 0, which is any bit, if not given")
        ->check(ZeroOrAbove())
        ->needs(app.get_option("--diverge"))
        ->group(group);
}

}  // namespace testbed
