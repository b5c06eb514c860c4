// SPDX-License-Identifier: BSD-2-Clause
import type { Contents, DocumentContent } from "../run/contents";
import type { Panel, PanelContext } from "../panels/panel";
import { empty } from "../panels/parts";
import type { PanelInfo } from "../panels/panel_table";
import { DocumentView } from "./document_view";

/** A panel that is described by a document. */
export function documentPanel(context: PanelContext, info: PanelInfo): Panel {
  const view = new DocumentView(context, info.word), word = info.word as keyof Contents;
  return {
    word: info.word, title: info.title, about: info.about, uses: [word, "moment"],
    note: (contents) => {
      const nodes = (contents[word] as DocumentContent | undefined)?.document;
      if (nodes !== undefined && view.hasNews(nodes)) context.reveal(info.word);
    },
    badge: (contents) => (contents[word] as DocumentContent | undefined)?.badge ?? "",
    view: (contents) => {
      const content = contents[word] as DocumentContent | undefined;
      return content?.document === undefined ? empty(info.about) : view.view(content.document);
    },
  };
}
