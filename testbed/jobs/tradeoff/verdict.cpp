// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of verdict.h.

#include "testbed/jobs/tradeoff/verdict.h"

#include <algorithm>

namespace testbed {

namespace {

const TradeCase* Find(std::span<const TradeCase> cases, const std::string& law, const RunSpec& setting) {
    const auto found =
        std::ranges::find_if(cases, [&](const TradeCase& one) { return one.law == law && one.setting == setting; });
    return found == cases.end() ? nullptr : &*found;
}

ErrorPoint PointOf(const Law& law, const TradeCase& one) {
    ErrorPoint point{one.GetCost().median, {}, HasFailed(law, one)};
    for (std::size_t i = 0; i < law.errors.size(); ++i) point.errors.push_back(FlooredError(law, one, i));
    return point;
}

/// The settings of one law in some families.
struct Choice {
    std::vector<ErrorPoint> points;
    std::vector<RunSpec> settings;
};

Choice Collect(const Law& law, std::span<const TradeCase> cases, std::span<const Family> families) {
    Choice choice;
    for (const TradeCase& one : cases) {
        if (one.law != law.name || std::ranges::find(families, FamilyOf(one.setting)) == families.end()) continue;
        choice.points.push_back(PointOf(law, one));
        choice.settings.push_back(one.setting);
    }
    return choice;
}

/// Whether Box2D's settings of the baseline's rate differ in no error by more than a hundredth.
bool CannotTrade(const Choice& box2d, const ErrorPoint& baseline) {
    constexpr double same = 1.01;
    int others = 0;
    for (std::size_t i = 0; i < box2d.points.size(); ++i) {
        const RunSpec& setting = box2d.settings[i];
        if (setting == GetBaseline() || GetRate(setting) != GetRate(GetBaseline())) continue;
        ++others;
        const ErrorPoint& point = box2d.points[i];
        if (CompareErrors(point, baseline) < 1.0 / same || CompareErrors(baseline, point) < 1.0 / same) return false;
    }
    return others > 0;
}

std::optional<double> Divide(std::optional<double> one, std::optional<double> other) {
    return one && other ? std::optional(*one / *other) : std::nullopt;
}

std::optional<bool> Meets(std::optional<double> error, double bound) {
    if (!error || bound == noBound) return std::nullopt;
    return *error <= bound;
}

}  // namespace

std::optional<double> LawGain::GetSpeedUp() const { return Divide(ours.speedUp, box2d.speedUp); }
std::optional<double> LawGain::GetErrorRatio() const { return Divide(ours.errorRatio, box2d.errorRatio); }

bool LawGain::IsLost() const {
    return standing == Standing::compared && (GetSpeedUp().value_or(0.0) < 1.0 || GetErrorRatio().value_or(0.0) < 1.0);
}

bool LawGain::IsBox2d3Faster() const { return box2d3.speedUp.value_or(0.0) > ours.speedUp.value_or(0.0); }
bool LawGain::IsBox2d3Closer() const { return box2d3.errorRatio.value_or(0.0) > ours.errorRatio.value_or(0.0); }

std::vector<LawGain> CompareWithBaseline(std::span<const TradeCase> cases, std::span<const Family> families) {
    constexpr Family theirs[] = {Family::box2d}, others[] = {Family::box2d3};
    std::vector<LawGain> gains;
    for (const Law* one : LawsOf(cases)) {
        const Law& law = *one;
        const TradeCase* found = Find(cases, law.name, GetBaseline());
        if (found == nullptr) continue;
        const ErrorPoint baseline = PointOf(law, *found);
        const Choice ours = Collect(law, cases, families), box2d = Collect(law, cases, theirs);
        LawGain gain{.law = &law,
                     .ours = Compare(ours.points, baseline),
                     .box2d = Compare(box2d.points, baseline),
                     .box2d3 = Compare(Collect(law, cases, others).points, baseline),
                     .cheapest = {},
                     .closest = {}};
        if (baseline.failed) {
            gain.standing = Standing::baselineFails;
        } else if (CannotTrade(box2d, baseline)) {
            gain.standing = Standing::cannotTrade;
        }
        if (gain.ours.cheapest) gain.cheapest = ours.settings[*gain.ours.cheapest];
        if (gain.ours.closest) gain.closest = ours.settings[*gain.ours.closest];
        gains.push_back(gain);
    }
    return gains;
}

Headline Summarise(std::span<const LawGain> gains) {
    Headline headline;
    std::vector<double> speedUps, ratios;
    for (const LawGain& gain : gains) {
        if (gain.standing != Standing::compared) continue;
        speedUps.push_back(gain.GetSpeedUp().value_or(0.0));
        ratios.push_back(gain.GetErrorRatio().value_or(0.0));
    }
    const auto median = [](const std::vector<double>& values) -> std::optional<double> {
        const double middle = NearestRankQuantile(values, 0.5);  // of an even number the lower one
        return middle > 0.0 ? std::optional(middle) : std::nullopt;
    };
    const auto count = [](const std::vector<double>& values) {
        return static_cast<int>(std::ranges::count_if(values, [](double value) { return value >= 1.0; }));
    };
    return {median(speedUps), median(ratios), static_cast<int>(speedUps.size()), count(speedUps), count(ratios)};
}

std::optional<bool> BoundRow::MeetsGame() const { return Meets(game, error->game); }
std::optional<bool> BoundRow::MeetsPrecise() const { return Meets(precise, error->precise); }

std::vector<BoundRow> CheckBounds(std::span<const TradeCase> cases) {
    std::vector<BoundRow> rows;
    for (const Law* one : LawsOf(cases)) {
        const Law& law = *one;
        const auto at = [&](const RunSpec& setting, std::size_t index) -> std::optional<double> {
            const TradeCase* found = Find(cases, law.name, setting);
            return found != nullptr ? std::optional(found->errors.at(index)) : std::nullopt;
        };
        for (std::size_t i = 0; i < law.errors.size(); ++i) {
            if (!at(GetBaseline(), i)) continue;
            rows.push_back({&law, &law.errors[i], at(GetDial(Accuracy::game), i), at(GetDial(Accuracy::precise), i),
                            at(GetSequential("scree"), i), at(GetBaseline(), i)});
        }
    }
    return rows;
}

bool HasMiss(std::span<const BoundRow> rows) {
    return std::ranges::any_of(rows, [](const BoundRow& row) {
        return !row.MeetsGame().value_or(true) || !row.MeetsPrecise().value_or(true);
    });
}

}  // namespace testbed
