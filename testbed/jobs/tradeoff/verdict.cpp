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

TradePoint PointOf(const Law& law, const TradeCase& one) { return {one.GetCost().median, FlooredError(law, one)}; }

std::optional<bool> Meets(std::optional<double> error, double bound) {
    if (!error || bound == noBound) return std::nullopt;
    return *error <= bound;
}

}  // namespace

Family FamilyOf(const RunSpec& setting) {
    if (setting.engine == "box2d") return Family::box2d;
    return IsSequential(setting) ? Family::sequential : Family::soft;
}

std::string NameFamily(Family family) {
    switch (family) {
        case Family::box2d:
            return "Box2D 2.4.1";
        case Family::sequential:
            return "Scree, sequential impulses";
        case Family::soft:
            break;
    }
    return "Scree, soft step";
}

std::vector<LawGain> CompareWithBaseline(std::span<const TradeCase> cases, std::span<const Family> families) {
    std::vector<LawGain> gains;
    for (const Law& law : GetLaws()) {
        const TradeCase* baseline = Find(cases, law.name, GetBaseline());
        if (!baseline) continue;
        std::vector<TradePoint> points;
        std::vector<RunSpec> settings;
        for (const TradeCase& one : cases) {
            if (one.law != law.name || std::ranges::find(families, FamilyOf(one.setting)) == families.end()) continue;
            points.push_back(PointOf(law, one));
            settings.push_back(one.setting);
        }
        LawGain gain{&law, Compare(points, PointOf(law, *baseline)), {}, {}};
        if (gain.gain.cheapest) gain.cheapest = settings[*gain.gain.cheapest];
        if (gain.gain.closest) gain.closest = settings[*gain.gain.closest];
        gains.push_back(gain);
    }
    return gains;
}

Headline Summarise(std::span<const LawGain> gains) {
    std::vector<double> speedUps, ratios;
    for (const LawGain& gain : gains) {
        if (gain.gain.speedUp) speedUps.push_back(*gain.gain.speedUp);
        if (gain.gain.errorRatio) ratios.push_back(*gain.gain.errorRatio);
    }
    return {GeometricMean(speedUps), GeometricMean(ratios), static_cast<int>(gains.size()),
            static_cast<int>(speedUps.size()), static_cast<int>(ratios.size())};
}

std::optional<bool> BoundRow::MeetsGame() const { return Meets(game, error->game); }
std::optional<bool> BoundRow::MeetsPrecise() const { return Meets(precise, error->precise); }

std::vector<BoundRow> CheckBounds(std::span<const TradeCase> cases) {
    std::vector<BoundRow> rows;
    for (const Law& law : GetLaws()) {
        const auto at = [&](const RunSpec& setting, std::size_t index) -> std::optional<double> {
            const TradeCase* one = Find(cases, law.name, setting);
            return one ? std::optional(one->errors.at(index)) : std::nullopt;
        };
        for (std::size_t i = 0; i < law.errors.size(); ++i) {
            if (!at(GetBaseline(), i)) continue;
            rows.push_back({&law, &law.errors[i], at(GetDial(Accuracy::game), i), at(GetDial(Accuracy::precise), i),
                            at(GetSequential("scree"), i), at(GetBaseline(), i)});
        }
    }
    return rows;
}

}  // namespace testbed
