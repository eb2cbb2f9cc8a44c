// What the fields of the form are called: parts are put in, values are set.
import type { Job } from './job';

interface Words {
  label?: string;
  hint?: string;
  placeholder?: string;
  /** What the first choice is called. */
  choice?: string;
}

const fields = {
  changeCost: {
    parts: { hint: 'for parts without a cost in the list; taking out is free' },
    model: { hint: 'for values without a cost below' },
  },
  unit: { parts: { choice: 'as in the list' }, model: { choice: 'no unit' } },
  never: {
    parts: { placeholder: 'CX-6, PSU 800, 75 W more than it gives' },
    model: { placeholder: 'Edge, MySQL' },
  },
  mounted: {
    parts: { label: 'Stays mounted in every test', placeholder: 'Frame, Controller' },
    model: { label: 'Fixed in every test', placeholder: 'OS = Windows 11' },
  },
  start: {
    parts: { label: 'Is on the bench before the first test', placeholder: 'Gear pump, Filter' },
    model: { label: 'Set before the first test', placeholder: 'Edge, MySQL' },
  },
  first: {
    parts: { placeholder: 'Gear pump, Filter, Cooler\nVane pump, Filter, Cooler' },
    model: { placeholder: 'Debian 12, Firefox, MySQL' },
  },
} satisfies Record<string, Record<Job['source'], Words>>;

type Worded = Record<
  keyof typeof fields,
  HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement
>;

export function reword(source: Job['source'], controls: Worded): void {
  for (const [key, control] of Object.entries(controls)) {
    const { label, hint, placeholder, choice }: Words = fields[key as keyof Worded][source];
    const place = control.closest('.field');
    if (label) {
      place!.querySelector('label')!.textContent = label;
    }
    if (hint) {
      place!.querySelector('.hint')!.textContent = hint;
    }
    if (placeholder) {
      control.setAttribute('placeholder', placeholder);
    }
    if (choice) {
      (control as HTMLSelectElement).options[0]!.textContent = choice;
    }
  }
}
