// The search of the report: hides the rows of the list of pages that lack one of the words.
const field = document.querySelector('input[type=search]');
const list = document.querySelector('#pages');
const none = document.querySelector('#none');
field.addEventListener('input', () => {
  const words = field.value.toLowerCase().split(/\s+/).filter(word => word);
  let found = 0;
  for (const row of list.querySelectorAll('tbody tr')) {
    const text = row.textContent.toLowerCase();
    row.hidden = !words.every(word => text.includes(word));
    if (row.hidden === false && row.querySelector('td')) found++;
  }
  none.hidden = found > 0;
});
