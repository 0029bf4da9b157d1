// What is wider than its place scrolls, and takes the focus so that keys scroll it, too.
const mark = () => {
  for (const one of document.querySelectorAll('pre, .formula, .table-wrapper, .toc-scroll, .sidebar-scroll')) {
    if (one.scrollWidth > one.clientWidth || one.scrollHeight > one.clientHeight + 1) one.tabIndex = 0;
    else one.removeAttribute('tabindex');
  }
};
window.addEventListener('load', mark);
window.addEventListener('resize', mark);
