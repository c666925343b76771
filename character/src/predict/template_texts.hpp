// SPDX-License-Identifier: MIT
// The files of templates/ as they were when the library was built.
#ifndef SINEW_CHARACTER_PREDICT_TEMPLATE_TEXTS_HPP
#define SINEW_CHARACTER_PREDICT_TEMPLATE_TEXTS_HPP

namespace sinew {

struct TemplateText {
  const char *name, *text;
};
extern const TemplateText kTemplateTexts[];  // by name; a null name ends them

}  // namespace sinew
#endif
