// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of report.h.

#include "testbed/jobs/find/report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "testbed/page/page_markup.h"

namespace testbed {

std::string DescribeMoment(const FoundMoment& found, const Session& session) {
    const Moment& moment = found.moment;
    std::string steps = fmt::format("step {}", moment.step);
    if (moment.lastStep > moment.step) steps += fmt::format("-{}", moment.lastStep);
    std::string bodies;
    for (const int body : moment.bodies) bodies += (bodies.empty() ? "" : ", ") + session.NameOf(body);
    return fmt::format("{}, {:.2f} s: {}: {}{}{}{}", steps, moment.time, moment.condition, bodies,
                       bodies.empty() ? "" : ": ", moment.what, found.picture.empty() ? "" : "; " + found.picture);
}

std::string WriteFindJson(const FindReport& report, const Session& session) {
    using Json = nlohmann::ordered_json;
    Json moments = Json::array();
    for (const FoundMoment& found : report.found) {
        const Moment& moment = found.moment;
        Json bodies = Json::array();
        for (const int body : moment.bodies) bodies.push_back({{"index", body}, {"name", session.GetName(body)}});
        Json row{{"condition", moment.condition}, {"step", moment.step}, {"last_step", moment.lastStep},
                 {"time", moment.time},           {"bodies", bodies},    {"size", nullptr},
                 {"unit", moment.unit},           {"what", moment.what}, {"picture", found.picture}};
        if (std::isfinite(moment.size)) row["size"] = moment.size;
        moments.push_back(std::move(row));
    }
    return Json{{"schema", 1},           {"input", report.input},           {"command", report.command},
                {"steps", report.steps}, {"conditions", report.conditions}, {"moments", moments}}
               .dump(2) +
           "\n";
}

std::string WriteFindJUnit(const FindReport& report, const Session& session) {
    std::string cases;
    int failures = 0;
    for (const std::string& condition : report.conditions) {
        std::string lines;
        for (const FoundMoment& found : report.found) {
            if (found.moment.condition == condition) lines += DescribeMoment(found, session) + "\n";
        }
        const std::string name =
            fmt::format("  <testcase classname=\"{}\" name=\"{}\"", EscapeHtml(report.input), condition);
        if (lines.empty()) {
            cases += name + "/>\n";
            continue;
        }
        ++failures;
        cases += fmt::format("{}>\n    <failure message=\"{}\">{}</failure>\n  </testcase>\n", name,
                             EscapeHtml(lines.substr(0, lines.find('\n'))), EscapeHtml(lines));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"scree find\" tests=\"{}\" failures=\"{}\">\n{}"
        "</testsuite>\n",
        report.conditions.size(), failures, cases);
}

}  // namespace testbed
