// `scenelore relations`: which relations hold between which planes, for other programs.
#include <fmt/core.h>

#include <map>
#include <optional>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "export/spark_dsg.hpp"
#include "options.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

using exports::GraphNode;
using exports::SceneGraph;

class RelationsCommand : public Command {
 public:
  std::string name() const override { return "relations"; }
  std::string summary() const override { return "Print the relations between the planes of a scan: text, JSON, GraphML, Spark-DSG."; }
  std::string example() const override {
    return "scenelore relations office.gpkg --relation above\n"
           "scenelore relations office.gpkg --all --dsg > office.dsg.json";
  }
  std::vector<Argument> arguments() override {
    return joined(std::vector<Argument>{positional("FILE", &file_, "FILE", "knowledge base file"),
                                        {"--scan", &scan_, "NAME", "which scan, where there are several", Effect::result},
                                        {"--relation", &only_, "NAME", "only this relation", Effect::result},
                                        {"--all", &all_, "", "every relation there is (default: those that constraint rows use)", Effect::result},
                                        json_argument(json_),
                                        {"--graphml", &graphml_, "", "print GraphML"},
                                        {"--dsg", &dsg_, "", "print JSON that Spark-DSG loads"}},
                  rules_.arguments());
  }

  int run() override {
    if (json_ + graphml_ + dsg_ > 1) throw UsageError("--json, --graphml and --dsg exclude each other");
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    rules::RuleSet rules = rules_.load(base, file_);
    const SceneGraph graph = graph_of(base, require_scan(base, file_, scan_), rules);
    if (json_ || graphml_ || dsg_) {
      fmt::print("{}", json_ ? exports::to_json(graph) : graphml_ ? exports::to_graphml(graph) : exports::to_spark_dsg(graph));
      return kOk;
    }
    std::map<kb::PlaneId, std::string> names;
    for (const GraphNode& node : graph.nodes) names[node.plane] = node.object_class.empty() ? "plane" : node.object_class;
    for (const kb::RelationFact& e : graph.edges) {
      fmt::print("{} {} {} {} {} {:.2f}\n", names[e.a], e.a, e.relation, names[e.b], e.b, e.degree);
    }
    return kOk;
  }

 private:
  SceneGraph graph_of(const kb::KnowledgeBase& base, const kb::Scan& scan, rules::RuleSet& rules) const {
    const pipeline::Situation situation = pipeline::assess(base, scan, rules);
    std::vector<std::string> wanted = all_ ? rules.relation_names() : rules::used_relations(situation.knowledge, rules);
    if (only_) {
      (void)rules.text(*only_);  // says which one was meant
      wanted = {*only_};
    }
    std::map<kb::PlaneId, kb::Label> labels;
    for (const kb::Label& label : base.labels(scan.id)) labels[label.plane] = label;
    SceneGraph graph{.scan = scan.name, .classes = situation.knowledge.classes,
                     .edges = rules.relate(situation.scene, wanted, {base.facts(scan.id), base.pair_geometry(scan.id)}).facts};
    for (std::size_t i = 0; i < situation.scene.ids.size(); ++i) {
      GraphNode node{.plane = situation.scene.ids[i], .shape = situation.scene.planes[i]};
      if (const auto label = labels.find(node.plane); label != labels.end()) {
        node.object_class = label->second.object_class;
        node.probability = label->second.probability;
        const int index = situation.knowledge.class_index(node.object_class);
        if (index >= 0) node.class_id = situation.knowledge.classes[static_cast<std::size_t>(index)].id;
        if (index >= 0) node.color = situation.knowledge.classes[static_cast<std::size_t>(index)].color;
      }
      graph.nodes.push_back(std::move(node));
    }
    return graph;
  }

  std::string file_, scan_;
  std::optional<std::string> only_;
  bool all_ = false, json_ = false, graphml_ = false, dsg_ = false;
  RuleArguments rules_;
};

}  // namespace

std::unique_ptr<Command> relations_command() { return std::make_unique<RelationsCommand>(); }

}  // namespace scenelore::tools
