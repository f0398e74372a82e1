// Types of TypeScript for the documents of encounters, of the core's JSON Schema.

/** The source of a module that exports Encounter and the types in it. What vibrates before is left out, as the core in
 *  WebAssembly does without. */
export function typesOf({ description, properties: { vibration: _, ...properties }, required, $defs }) {
  const whole = { type: 'object', properties, required };
  const named = {
    ...Object.fromEntries(Object.entries($defs).map(([name, schema]) => [typeName(name), schema])),
    First: properties.first, Against: properties.against,
  };
  for (const name of ['first', 'against']) whole.properties[name] = { $ref: name };
  const types = Object.entries({ ...named, Encounter: { ...whole, description } })
    .map(([name, schema]) => `${comment(schema, '')}export type ${name} = ${typeOf(schema, '')};\n`);
  return `// Made by web/plugins/documents.mjs of the core's schema.\n\n${types.join('\n')}`.replaceAll(/ +$/gm, '');
}

/** As in ModalBody. */
const typeName = (name) => name.split('_').map((word) => word[0].toUpperCase() + word.slice(1)).join('');

/** The type of a schema. @param indent of the line on which it begins */
function typeOf(schema, indent) {
  if (schema.$ref) return typeName(schema.$ref.split('/').at(-1));
  if (schema.const !== undefined) return JSON.stringify(schema.const);
  if (schema.enum) return schema.enum.map((value) => JSON.stringify(value)).join(' | ');
  switch (schema.type) {
    case 'integer':
    case 'number': return 'number';
    case 'string': return 'string';
    case 'boolean': return 'boolean';
    case 'array':
      if (schema.prefixItems) return `readonly [${schema.prefixItems.map((each) => typeOf(each, indent)).join(', ')}]`;
      return `readonly ${inParentheses(typeOf(schema.items, indent))}[]`;
    case 'object': return objectOf(schema, indent);
  }
  if (schema.oneOf) return schema.oneOf.map((each) => `\n${indent}  | ${typeOf(each, `${indent}  `)}`).join('');
  throw new Error(`documents.mjs: got the schema ${JSON.stringify(schema)}, allowed one of a type`);
}

const inParentheses = (type) => (/^[^{]*[|&]|^readonly/.test(type) ? `(${type})` : type);

/** Of members that stand in for each other, as `oneOf` of their names has it, one must be there. */
function objectOf({ properties, required = [], oneOf = [] }, indent) {
  const inner = `${indent}  `;
  const lines = Object.entries(properties).map(([name, schema]) => {
    const key = required.includes(name) ? name : `${name}?`;
    return `${comment(schema, inner)}${inner}readonly ${key}: ${typeOf(schema, inner)};\n`;
  });
  const choices = oneOf.map((each) => `{ ${each.required.map((name) => `readonly ${name}: {}`).join('; ')} }`);
  return `{\n${lines.join('')}${indent}}${choices.length > 0 ? ` & (${choices.join(' | ')})` : ''}`;
}

/** What a schema says in words: what it is, its unit, range and default. */
function comment(schema, indent) {
  const { description, minimum, exclusiveMinimum, maximum, exclusiveMaximum, default: otherwise } = schema;
  const words = [
    description, schema['x-unit'], exclusiveMinimum !== undefined && `above ${exclusiveMinimum}`,
    minimum !== undefined && `at least ${minimum}`, exclusiveMaximum !== undefined && `below ${exclusiveMaximum}`,
    maximum !== undefined && `at most ${maximum}`, otherwise !== undefined && `by default ${otherwise}`,
  ].filter(Boolean);
  return words.length > 0 ? `${indent}/** ${words.join('; ')} */\n` : '';
}
