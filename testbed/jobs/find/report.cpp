// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of report.h.

#include "testbed/jobs/find/report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "testbed/base/json_print.h"
#include "testbed/base/text.h"
#include "testbed/page/page.h"
#include "testbed/page/page_markup.h"

namespace testbed {

std::string DescribeMoment(const FoundMoment& found, const Session& session) {
    const Moment& moment = found.moment;
    std::string steps = fmt::format("step {}", moment.step);
    if (moment.lastStep > moment.step) steps += fmt::format("-{}", moment.lastStep);
    std::string bodies;
    for (const int body : moment.bodies) bodies += (bodies.empty() ? "" : ", ") + session.NameOf(body);
    return fmt::format("{}, {:.2f} s: {}: {}{}{}{}{}", steps, moment.time, moment.condition, bodies,
                       bodies.empty() ? "" : ": ", moment.what, found.picture.empty() ? "" : "; " + found.picture,
                       found.link.empty() ? "" : "; " + found.link);
}

std::string Summarize(const FindReport& report) {
    const std::size_t count = report.found.size();
    return fmt::format("{} moment{} in {} step{}: {}", count, count == 1 ? "" : "s", report.steps,
                       report.steps == 1 ? "" : "s", fmt::join(report.conditions, ", "));
}

std::string LinkTo(const std::string& timeline, const Moment& moment) {
    return fmt::format("{}#step={}{}{}", QuoteForLink(timeline), moment.step,
                       moment.bodies.empty() ? "" : "&body=", fmt::join(moment.bodies, ","));
}

std::string WriteFindJson(const FindReport& report, const Session& session) {
    using Json = nlohmann::ordered_json;
    Json moments = Json::array();
    for (const FoundMoment& found : report.found) {
        const Moment& moment = found.moment;
        Json bodies = Json::array();
        for (const int body : moment.bodies) bodies.push_back({{"index", body}, {"name", session.GetName(body)}});
        Json row{{"condition", moment.condition},
                 {"step", moment.step},
                 {"last_step", moment.lastStep},
                 {"time", moment.time},
                 {"bodies", bodies},
                 {"size", nullptr},
                 {"unit", moment.unit},
                 {"what", moment.what},
                 {"picture", found.picture},
                 {"link", found.link}};
        if (std::isfinite(moment.size)) row["size"] = moment.size;
        moments.push_back(std::move(row));
    }
    const Json document{{"schema", 1},           {"input", report.input},           {"command", report.command},
                        {"steps", report.steps}, {"conditions", report.conditions}, {"moments", moments}};
    return PrintJson(document, 2) + "\n";
}

std::string WriteFindJUnit(const FindReport& report, const Session& session) {
    std::string cases;
    int failures = 0;
    for (const std::string& condition : report.conditions) {
        std::string lines;
        for (const FoundMoment& found : report.found) {
            if (found.moment.condition == condition) lines += ToPrintable(DescribeMoment(found, session)) + "\n";
        }
        const std::string name =
            fmt::format("  <testcase classname=\"{}\" name=\"{}\"", EscapeHtml(ToPrintable(report.input)), condition);
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

void WriteFindPage(const std::filesystem::path& file, const FindReport& report, const Session& session) {
    namespace fs = std::filesystem;
    // Links and pictures lead from where the page is.
    const std::string timeline =
        report.timeline.empty()
            ? ""
            : fs::absolute(report.timeline).lexically_relative(fs::absolute(file).parent_path()).generic_string();
    PageTable table{.columns = {{.name = "step", .numeric = true},
                                {.name = "time", .unit = "s", .numeric = true},
                                {.name = "moment"},
                                {.name = "bodies"},
                                {.name = "size", .numeric = true},
                                {.name = "what"}},
                    .filter = report.found.size() > 10};
    PageFigures figures{.columns = 2};
    for (const FoundMoment& found : report.found) {
        const Moment& moment = found.moment;
        std::string bodies;
        for (const int body : moment.bodies) bodies += (bodies.empty() ? "" : ", ") + session.NameOf(body);
        PageCell step = PageCell::Number(moment.step);
        if (!timeline.empty()) step.link = LinkTo(timeline, moment);
        PageCell size;
        if (!moment.unit.empty()) size = PageCell::Number(moment.size, 3);
        if (!moment.unit.empty()) size.text += " " + moment.unit;
        table.rows.push_back({step, PageCell::Number(moment.time, 2), moment.condition, bodies, size, moment.what});
        if (found.picture.empty()) continue;
        figures.figures.push_back({.title = fmt::format("Step {}: {}", moment.step, moment.condition),
                                   .caption = DescribeMoment({moment}, session),
                                   .file = found.picture});
    }
    Page page{.title = fmt::format("{}: moments", report.input),
              .intro = fmt::format("`{}`\n\n{}.", report.command, Summarize(report))};
    PageSection section{.title = "Moments"};
    if (!timeline.empty()) section.intro = "A step leads to it in the timeline, with the bodies chosen.";
    if (!report.found.empty()) section.blocks.push_back(table);
    if (report.found.empty()) section.blocks.push_back(PageNote{"Nothing was found.", PageTone::good});
    page.sections.push_back(std::move(section));
    if (!figures.figures.empty()) page.sections.push_back({.title = "Pictures", .blocks = {figures}});
    WritePage(file, page);
}

}  // namespace testbed
