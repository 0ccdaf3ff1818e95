#pragma once

#include <libxml/parser.h>
#include <libxml/xpath.h>

#include <memory>
#include <string>
#include <vector>

namespace byhand::tests {

/// A piece of XML, read strictly.
class Markup {
 public:
  explicit Markup(const std::string& text)
      : document_(xmlReadMemory(text.data(), static_cast<int>(text.size()), "", "UTF-8",
                                XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_HUGE),
                  xmlFreeDoc) {}

  /// Empty if it is well-formed, else what is wrong with it.
  std::string mistake() const {
    const xmlError* const error = document_ ? nullptr : xmlGetLastError();
    return document_ ? "" : error ? "line " + std::to_string(error->line) + ": " + error->message : "unreadable";
  }

  /// The text of each node of an XPath expression without namespaces: "//section/@id".
  std::vector<std::string> all(const std::string& path) const {
    std::vector<std::string> found;
    const std::unique_ptr<xmlXPathContext, void (*)(xmlXPathContextPtr)> context(
        xmlXPathNewContext(document_.get()), xmlXPathFreeContext);
    const std::unique_ptr<xmlXPathObject, void (*)(xmlXPathObjectPtr)> result(
        xmlXPathEvalExpression(reinterpret_cast<const xmlChar*>(path.c_str()), context.get()), xmlXPathFreeObject);
    const xmlNodeSet* const nodes = result ? result->nodesetval : nullptr;
    for (int i = 0; nodes && i < nodes->nodeNr; ++i) {
      const std::unique_ptr<xmlChar, void (*)(void*)> text(xmlNodeGetContent(nodes->nodeTab[i]), xmlFree);
      found.emplace_back(reinterpret_cast<const char*>(text.get()));
    }
    return found;
  }

 private:
  std::unique_ptr<xmlDoc, void (*)(xmlDocPtr)> document_;
};

/// A page without its namespace, so that XPath is short.
inline Markup of_page(std::string text) {
  for (const std::string name :
       {" xmlns=\"http://www.w3.org/1999/xhtml\"", " xmlns=\"http://www.w3.org/1998/Math/MathML\"",
        " xmlns=\"http://www.w3.org/2000/svg\""})
    for (auto at = text.find(name); at != std::string::npos; at = text.find(name)) text.erase(at, name.size());
  return Markup(text);
}

}  // namespace byhand::tests
