// ajar merge: one image of several that hold other samples of the same picture, as `ajar render
// --first-sample` divides them among runs and machines. What it makes is what one run would have made, up to
// the rounding of the parts' floats, and says so in its metadata.
#include "image/merge.hpp"
#include "ajar/save_image.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/render_options.hpp"
#include "image/read.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace ajar::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* EXAMPLES = "  ajar render scene.glb -o a.exr --float --samples 512\n"
                                 "  ajar render scene.glb -o b.exr --float --samples 512 --first-sample 512\n"
                                 "  ajar merge a.exr b.exr -o out.exr -o out.png";

constexpr const char* SETTINGS = "ajar:settings";

struct Options {
    std::vector<std::string> parts;
    RenderOptions render; // outputs and how they are saved
};

struct Part {
    std::string file;
    std::map<std::string, std::string> metadata; // but for the settings
    Json settings;
    std::uint64_t first = 0; // sample
    std::uint64_t samples = 0;
    bool attributes = false; // it has layers of them, which a merged image has not

    std::uint64_t end() const { return first + samples; }
};

// What a file says of itself.
Part look_at(const std::string& file) {
    const Image image = read_image(file);
    Part part;
    part.file = file;
    for (const auto& [name, text] : image.metadata) part.metadata[name] = text;
    part.settings = Json::parse(part.metadata[SETTINGS], nullptr, false);
    part.metadata.erase(SETTINGS);
    const auto number = [&](const char* name) -> std::uint64_t {
        const bool there = part.settings.is_object() && part.settings.contains(name) &&
                           part.settings[name].is_number_unsigned();
        return there ? part.settings[name].get<std::uint64_t>() : 0;
    };
    part.first = number("first_sample");
    part.samples = number("samples");
    // What a lab keeps has more samples than the settings tell.
    if (part.samples == 0 || part.metadata.contains("ajar:lab_key") || !image.find("variance"))
        throw Error(fmt::format("{}: does not tell which samples it holds (merge files that `ajar render` "
                                "wrote as .exr)",
                                file));
    if (part.settings.contains("interrupted"))
        throw Error(fmt::format("{}: was interrupted, so some pixels have more samples than others (render "
                                "it again; --time-limit ends evenly)",
                                file));
    part.attributes = image.find("albedo") != nullptr;
    return part;
}

// The samples are what parts may differ in, and whether attributes were asked for.
Json common_settings(Json settings) {
    for (const char* own : {"first_sample", "samples", "aovs"}) settings.erase(own);
    return settings;
}

// Of one picture: the same settings, scene, shaders and version. Devices may differ.
void expect_same_picture(const Part& part, const Part& other) {
    const Json a = common_settings(part.settings), b = common_settings(other.settings);
    const auto text = [](const Json& settings, const std::string& name) {
        return settings.contains(name) ? settings[name].dump(-1, ' ', false, Json::error_handler_t::replace)
                                       : std::string("not told");
    };
    for (const Json* settings : {&a, &b})
        for (const auto& [name, value] : settings->items())
            if (text(a, name) != text(b, name))
                throw Error(fmt::format("{}: {} is {}, in {} {} (parts differ in --first-sample and "
                                        "--samples alone)",
                                        part.file, name, text(a, name), other.file, text(b, name)));
    for (const char* name : {"ajar:version", "ajar:scene_hash", "ajar:shader_hash"}) {
        const auto value = [&](const Part& p) {
            const auto found = p.metadata.find(name);
            return found == p.metadata.end() ? std::string() : found->second;
        };
        if (value(part) != value(other))
            throw Error(fmt::format("{}: {} differs from that of {} (render both with the same Ajar and the "
                                    "same scene)",
                                    part.file, name, other.file));
    }
}

// In order of their samples, which follow each other without gap or overlap.
std::vector<Part> look_at_all(const std::vector<std::string>& files) {
    std::vector<Part> parts;
    for (const std::string& file : files) {
        parts.push_back(look_at(file));
        expect_same_picture(parts.back(), parts.front());
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.first < b.first; });
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const Part &before = parts[i - 1], &part = parts[i];
        if (part.first < before.end())
            throw Error(fmt::format("{}: begins with sample {}, which {} has too", part.file, part.first,
                                    before.file));
        if (part.first > before.end())
            throw Error(
                fmt::format("{}: begins with sample {}, and no part has those from {} on (render them "
                            "with --first-sample {} --samples {})",
                            part.file, part.first, before.end(), before.end(), part.first - before.end()));
    }
    return parts;
}

// That of one run; of the devices all that took part.
std::vector<std::pair<std::string, std::string>> metadata_of(const std::vector<Part>& parts) {
    Json settings = parts.front().settings;
    settings["samples"] = parts.back().end() - parts.front().first;
    settings["aovs"] = false;
    std::map<std::string, std::string> all = parts.front().metadata;
    for (const char* name : {"ajar:device", "ajar:driver"}) {
        std::vector<std::string> different;
        for (const Part& part : parts)
            if (const auto found = part.metadata.find(name);
                found != part.metadata.end() &&
                std::find(different.begin(), different.end(), found->second) == different.end())
                different.push_back(found->second);
        all[name] = fmt::format("{}", fmt::join(different, ", "));
    }
    all[SETTINGS] = settings.dump(-1, ' ', false, Json::error_handler_t::replace);
    return {all.begin(), all.end()};
}

int run(const Options& o) {
    if (o.parts.size() < 2) throw UsageError("one part is a picture already: two at least can be merged");
    if (o.render.outputs.empty()) throw UsageError("nothing to write: -o FILE is missing");
    for (const std::string& file : o.render.outputs) check_save(file, o.render.save);
    const std::vector<Part> parts = look_at_all(o.parts);
    SampleMean mean;
    // One picture at a time in memory.
    for (const Part& part : parts) mean.add(read_image(part.file), part.samples);
    Image image = mean.image();
    image.metadata = metadata_of(parts);
    for (const std::string& file : o.render.outputs) save_image(file, image, o.render.save);
    if (std::any_of(parts.begin(), parts.end(), [](const Part& part) { return part.attributes; }))
        print_line("notice", "albedo and other attributes were left out");
    return EXIT_OK;
}

} // namespace

Command merge_command(CLI::App& parent) {
    CLI::App* app =
        parent.add_subcommand("merge", "Makes one image of several that hold other samples of one picture");
    app->footer(EXAMPLES);
    const auto options = std::make_shared<Options>();
    app->add_option("PART", options->parts,
                    "EXR files by `ajar render` that differ in --first-sample and --samples alone")
        ->required()
        ->expected(2, -1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    declare_files(*app, options->render);
    declare_display(*app, options->render);
    app->remove_option(app->get_option("--progress"));
    return {app, [options] { return run(*options); }};
}

} // namespace ajar::cli
