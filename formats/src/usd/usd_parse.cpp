// SPDX-License-Identifier: MIT
#include "usd/usd_parse.hpp"

#include <cmath>

#include "sinew_formats/error.hpp"
#include "usd/usd_tokens.hpp"

namespace sinew {
namespace {

constexpr size_t kMostDepth = 64;

// What may stand before the name of metadata, a property or a relationship to change a list that other layers began.
bool is_list_word(const UsdTokens& tokens) {
  for (const char* word : {"add", "append", "prepend", "delete", "reorder"})
    if (tokens.is_name(word)) return true;
  return false;
}

class Parser {
 public:
  Parser(const std::string& path, std::string_view text) : tokens_(path, text) {}

  UsdPrim parse() {
    UsdPrim root;
    if (tokens_.is_mark('(')) metadata(&root.metadata);
    while (tokens_.kind() != UsdWord::kEnd) {
      if (tokens_.is_name("reorder")) {
        order_of_names();
        continue;
      }
      if (!is_specifier()) tokens_.fail("def, over or class");
      root.children.push_back(prim("", 0));
    }
    return root;
  }

 private:
  bool is_specifier() const { return tokens_.is_name("def") || tokens_.is_name("over") || tokens_.is_name("class"); }

  std::string take_name(const char* expected) {
    if (tokens_.kind() != UsdWord::kName) tokens_.fail(expected);
    std::string name(tokens_.raw());
    tokens_.next();
    return name;
  }

  std::string take_string(const char* expected) {
    if (tokens_.kind() != UsdWord::kString) tokens_.fail(expected);
    std::string text = tokens_.content();
    tokens_.next();
    return text;
  }

  void take_mark(char mark) {
    if (!tokens_.is_mark(mark)) tokens_.fail(std::string("'") + mark + "'");
    tokens_.next();
  }

  bool skip_mark(char mark) {
    if (!tokens_.is_mark(mark)) return false;
    tokens_.next();
    return true;
  }

  // "reorder nameChildren = [...]": the order that another layer's names get.
  void order_of_names() {
    tokens_.next();
    (void)take_name("nameChildren, rootPrims or properties");
    take_mark('=');
    UsdValue value;
    read_value(&value, 0);
  }

  UsdPrim prim(const std::string& above, size_t depth) {
    if (depth > kMostDepth) tokens_.fail("at most 64 prims one below the other");
    UsdPrim out;
    out.specifier = take_name("def, over or class");
    if (tokens_.kind() == UsdWord::kName) out.type = take_name("a type");
    out.name = take_string("the name of a prim in quotes");
    out.path = above + "/" + out.name;
    if (tokens_.is_mark('(')) metadata(&out.metadata);
    take_mark('{');
    contents(&out, depth);
    return out;
  }

  // What stands between { and }, to the end of it.
  void contents(UsdPrim* out, size_t depth) {
    while (!skip_mark('}')) {
      if (skip_mark(';')) continue;
      if (is_specifier()) {
        out->children.push_back(prim(out->path, depth + 1));
      } else if (tokens_.is_name("variantSet")) {
        variants(out, depth);
      } else {
        property(out);
      }
    }
  }

  // variantSet "name" = { "one" (...) { ... } }
  void variants(UsdPrim* out, size_t depth) {
    if (depth > kMostDepth) tokens_.fail("at most 64 variants one below the other");
    tokens_.next();
    (void)take_string("the name of a variant set in quotes");
    take_mark('=');
    take_mark('{');
    while (!skip_mark('}')) {
      UsdPrim left_out;
      left_out.name = take_string("the name of a variant in quotes");
      if (tokens_.is_mark('(')) metadata(&left_out.metadata);
      take_mark('{');
      contents(&left_out, depth + 1);
      out->has_variants = true;
    }
  }

  void property(UsdPrim* out) {
    if (tokens_.is_name("reorder")) {
      order_of_names();
      return;
    }
    while (tokens_.is_name("custom") || tokens_.is_name("uniform") || tokens_.is_name("varying") ||
           tokens_.is_name("config") || is_list_word(tokens_))
      tokens_.next();
    std::string type = take_name("a property, a prim or '}'");
    if (skip_mark('[')) {
      take_mark(']');
      type += "[]";
    }
    UsdProperty& property = out->properties[take_name("the name of a property")];
    property.type = type;
    std::string part;
    if (skip_mark('.')) part = take_name("timeSamples or connect");
    const bool has_value = skip_mark('=');
    if (has_value) {
      if (part == "timeSamples") {
        time_samples(&property);
      } else if (part == "connect" || type == "rel") {
        UsdValue value;
        read_value(&value, 0);
        property.targets.insert(property.targets.end(), value.texts.begin(), value.texts.end());
      } else {
        property.value = {};
        property.has_value = !tokens_.is_name("None");
        read_value(&property.value, 0);
      }
    }
    if (tokens_.is_mark('(')) metadata(&property.metadata);
  }

  // { 0: value, 1: value, }
  void time_samples(UsdProperty* property) {
    take_mark('{');
    while (!skip_mark('}')) {
      if (tokens_.kind() != UsdWord::kNumber) tokens_.fail("a time or '}'");
      const double time = tokens_.number();
      tokens_.next();
      take_mark(':');
      const bool blocked = tokens_.is_name("None");
      UsdValue value;
      read_value(&value, 0);
      if (!blocked) property->samples[time] = std::move(value);
      if (!skip_mark(',') && !tokens_.is_mark('}')) tokens_.fail("',' or '}'");
    }
  }

  // Numbers and texts of a value are appended to `out`.
  void read_value(UsdValue* out, size_t depth) {
    if (depth > kMostDepth) tokens_.fail("at most 64 brackets one in the other");
    switch (tokens_.kind()) {
      case UsdWord::kNumber:
        out->numbers.push_back(tokens_.number());
        tokens_.next();
        return;
      case UsdWord::kString:
      case UsdWord::kPath:
        out->texts.push_back(tokens_.content());
        tokens_.next();
        return;
      case UsdWord::kAsset:
        out->texts.push_back(tokens_.content());
        tokens_.next();
        if (tokens_.kind() == UsdWord::kPath) tokens_.next();             // @file@</Prim>
        if (tokens_.is_mark('(') && depth > 0) skip_layer_offset(depth);  // in a list of references
        return;
      case UsdWord::kName:
        word(out);
        return;
      default:
        break;
    }
    if (tokens_.is_mark('(')) return items('(', ')', out, depth);
    if (tokens_.is_mark('[')) return items('[', ']', out, depth);
    if (tokens_.is_mark('{')) {
      UsdMetadata ignored;
      dictionary("", &ignored, depth);
      return;
    }
    tokens_.fail("a value");
  }

  // None, true, inf; any other word is a token.
  void word(UsdValue* out) {
    const std::string text = take_name("a value");
    if (text == "None" || text == "AnimationBlock") return;
    if (text == "true" || text == "false")
      out->numbers.push_back(text == "true" ? 1 : 0);
    else if (text == "inf" || text == "nan")
      out->numbers.push_back(text == "inf" ? HUGE_VAL : NAN);
    else
      out->texts.push_back(text);
  }

  void items(char open, char close, UsdValue* out, size_t depth) {
    take_mark(open);
    size_t width = 0;
    while (!skip_mark(close)) {
      const size_t before = out->numbers.size();
      read_value(out, depth + 1);
      const size_t here = out->numbers.size() - before;
      if (width != 0 && here != width) tokens_.fail("tuples of one length");
      width = here;
      if (!skip_mark(',') && !tokens_.is_mark(close)) tokens_.fail(std::string("',' or '") + close + "'");
    }
    if (open == '[' && width > 0) out->width = width;
  }

  // (offset = 10; scale = 2) behind a reference.
  void skip_layer_offset(size_t depth) {
    UsdMetadata ignored;
    metadata(&ignored, depth + 1);
  }

  // ( "comment" key = value; prepend key = value ), between which there are line ends or semicolons.
  void metadata(UsdMetadata* out, size_t depth = 0) {
    take_mark('(');
    while (!skip_mark(')')) {
      if (skip_mark(';') || skip_mark(',')) continue;
      if (tokens_.kind() == UsdWord::kString) {
        tokens_.next();  // a comment
        continue;
      }
      if (is_list_word(tokens_)) tokens_.next();
      const std::string key = take_name("metadata or ')'");
      take_mark('=');
      if (tokens_.is_mark('{')) {
        dictionary(key, out, depth);
        continue;
      }
      UsdValue value;
      read_value(&value, depth);
      (*out)[key] = std::move(value);
    }
  }

  // { string name = "value" }, or the times of samples.
  void dictionary(const std::string& name, UsdMetadata* out, size_t depth) {
    if (depth > kMostDepth) tokens_.fail("at most 64 dictionaries one in the other");
    take_mark('{');
    while (!skip_mark('}')) {
      if (skip_mark(';') || skip_mark(',')) continue;
      if (tokens_.kind() == UsdWord::kNumber) {
        tokens_.next();
        take_mark(':');
        UsdValue ignored;
        read_value(&ignored, depth + 1);
        continue;
      }
      std::string key;
      if (tokens_.kind() == UsdWord::kString) {
        key = take_string("a name");  // relocates = { "a": "b" } and the like
        if (!skip_mark(':')) take_mark('=');
      } else if (tokens_.kind() == UsdWord::kPath) {
        tokens_.next();
        take_mark(':');
      } else {
        (void)take_name("a type or '}'");
        if (skip_mark('[')) take_mark(']');
        key = tokens_.kind() == UsdWord::kString ? take_string("a name") : take_name("a name");
        take_mark('=');
      }
      if (tokens_.is_mark('{')) {
        dictionary(name + ":" + key, out, depth + 1);
        continue;
      }
      UsdValue value;
      read_value(&value, depth + 1);
      (*out)[name + ":" + key] = std::move(value);
    }
  }

  UsdTokens tokens_;
};

}  // namespace

UsdPrim parse_usda(const std::string& path, std::string_view text) {
  if (text.substr(0, 8) == "PXR-USDC")
    throw Error(path +
                ": expected USD's text form, found its binary form (crate); usdcat --out NAME.usda makes text of it");
  if (text.substr(0, 5) != "#usda")
    throw Error(path + ": expected USD's text form, which begins with #usda, found another file");
  return Parser(path, text).parse();
}

const UsdProperty* find_property(const UsdPrim& prim, const std::string& name) {
  const auto at = prim.properties.find(name);
  return at == prim.properties.end() ? nullptr : &at->second;
}

const UsdValue* find_value(const UsdPrim& prim, const std::string& name) {
  const UsdProperty* property = find_property(prim, name);
  if (property == nullptr) return nullptr;
  if (property->has_value) return &property->value;
  return property->samples.empty() ? nullptr : &property->samples.begin()->second;
}

std::string text_of(const UsdPrim& prim, const std::string& name, const std::string& otherwise) {
  const UsdValue* value = find_value(prim, name);
  return value == nullptr || value->texts.empty() ? otherwise : value->texts[0];
}

}  // namespace sinew
