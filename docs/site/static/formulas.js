// Sets every formula of a page.
document.addEventListener('DOMContentLoaded', () => {
  for (const place of document.querySelectorAll('.math')) {
    katex.render(place.textContent, place, {displayMode: place.tagName === 'DIV', throwOnError: false});
  }
});
