/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 2290d702b73141f0cb0329b7b28577fc7d4987259c2214db5a98290a8b83ff76 */
(()=>{function S(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function us(n,t,e){let i=S("button",{type:"button",title:t,"aria-label":t},n);return i.addEventListener("click",e),i}var ml=n=>Ih(n,24);function Ih(n,t){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox",`0 0 ${t} ${t}`),t!==24&&i.setAttribute("preserveAspectRatio","none"),i.setAttribute("aria-hidden","true");let s=document.createElementNS(e,"path");return s.setAttribute("d",n),i.append(s),i}function mr({colour:n,dash:t,area:e}){let i="http://www.w3.org/2000/svg",s=document.createElementNS(i,"svg");s.setAttribute("viewBox","0 0 24 8"),s.setAttribute("aria-hidden","true"),s.classList.add("sample");let r=document.createElementNS(i,"path");return r.setAttribute("d",e?"M0 0H24V8H0Z":"M0 4H24"),e&&(r.style.fill=n),r.setAttribute("stroke",e?"none":n),r.setAttribute("stroke-dasharray",t.join(" ")),s.append(r),s}var Zp=3,Fv=1e4;function gr(n,t){let e=URL.createObjectURL(n);S("a",{href:e,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(e),Fv)}function qn(n){return`${document.title.split(/: | with /)[0]} ${n}`.toLowerCase().normalize("NFKD").replace(/[^a-z0-9.]+/g,"-").replace(/^-+|-+$/g,"")||"plot"}function gl(n,t,e){let i=S("button",{type:"button","aria-label":`download ${n} of ${t}`,title:`download as ${n}`},n);return i.addEventListener("click",e),i}function qi(n,t,e){let i=()=>gr(new Blob([e().svg],{type:"image/svg+xml"}),`${t()}.svg`);return S("span",{className:"saves"},gl("PNG",n,async()=>gr(await Bv(e()),`${t()}.png`)),gl("SVG",n,i))}async function Bv({svg:n,width:t,height:e}){let i=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"}));try{let s=S("img",{width:t,height:e});await new Promise((o,a)=>{s.onload=o,s.onerror=a,s.src=i});let r=S("canvas",{width:Zp*t,height:Zp*e});return r.getContext("2d").drawImage(s,0,0,r.width,r.height),await new Promise(o=>r.toBlob(o,"image/png"))}finally{URL.revokeObjectURL(i)}}function Kp(){for(let n of document.querySelectorAll("figure.drawn")){let[t,e]=[n.querySelector("img"),n.querySelector("source")],i=n.closest("section")?.id??"figure",s=[["PNG",t.src],["SVG",e.srcset]].map(([r,o])=>gl(r,`the figure ${i}`,()=>gr(zv(o),`${qn(i)}.${r.toLowerCase()}`)));n.append(S("div",{className:"saves save-foot"},...s))}}function zv(n){let[t,e]=n.split(","),i=atob(e);return new Blob([Uint8Array.from(i,s=>s.charCodeAt(0))],{type:/:(.*?);/.exec(t)[1]})}function Oe(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function On(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function Lh(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}function be(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}var Nh={};function Jp(n){Nh=n}function jp(n,t){let e=Nh[n],[i,s]=e.find(([,,r])=>t>=r||t===0)??e.at(-1);return{unit:i,factor:s}}function Qp(n){return Object.values(Nh).flat().find(([t])=>t===n)[1]}function Fs(n,t){let{unit:e,factor:i}=jp(t,Math.abs(n));return`${be(i*n)} ${e}`}function ia(n){return n.unit?{unit:n.unit,factor:1}:jp("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function Yi(n,t){let{unit:e,factor:i}=ia(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${On(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var Ks={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Js={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Lm=0,cd=1,Nm=2;var Oa=1,Dm=2,So=3,js=0,Kn=1,zn=2,wr=0,Mo=1,ud=2,hd=3,dd=4,Om=5;var Ar=100,Um=101,km=102,Fm=103,Bm=104,zm=200,Vm=201,Gm=202,Hm=203,fd=204,pd=205,Wm=206,$m=207,Xm=208,qm=209,Ym=210,Zm=211,Km=212,Jm=213,jm=214,Gl=0,Hl=1,Wl=2,uo=3,$l=4,Xl=5,ql=6,Yl=7,vc=0,Qm=1,tg=2,ts=0,md=1,gd=2,xd=3,_d=4,yd=5,vd=6,bd=7;var Sd=300,Er=301,wo=302,bc=303,Sc=304,Zl=1e3,Ji=1001,Kl=1002,Nn=1003,eg=1004;var Ua=1005;var Zn=1006,Mc=1007;var ws=1008;var ti=1009,Md=1010,wd=1011,Ao=1012,wc=1013,Li=1014,Si=1015,Ni=1016,Ac=1017,Ec=1018,Tr=1020,Ad=35902,Ed=35899,Td=1021,Cd=1022,Di=1023,xs=1026,As=1027,Tc=1028,Cc=1029,Qs=1030,Rc=1031;var Pc=1033,ka=33776,Fa=33777,Ba=33778,za=33779,Ic=35840,Lc=35841,Nc=35842,Dc=35843,Oc=36196,Uc=37492,kc=37496,Fc=37488,Bc=37489,Va=37490,zc=37491,Vc=37808,Gc=37809,Hc=37810,Wc=37811,$c=37812,Xc=37813,qc=37814,Yc=37815,Zc=37816,Kc=37817,Jc=37818,jc=37819,Qc=37820,tu=37821,eu=36492,nu=36494,iu=36495,su=36283,ru=36284,Ga=36285,ou=36286;var pa=2300,Jl=2301,zl=2302,ed=2303,nd=2400,id=2401,sd=2402;var ng=3200;var au=0,ig=1,Es="",li="srgb",ma="srgb-linear",ga="linear",Ce="srgb";var Vl=7680,Rd=7681;var Pd=517;var sg=519,rg=512,og=513,ag=514,Id=515,lg=516,cg=517,Ld=518,Nd=519,ug=35044,Ha=35048;var Dd="300 es",vi=2e3,ho=2001;function Vv(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Gv(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function xa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function hg(){let n=xa("canvas");return n.style.display="block",n}var tm={},fo=null;function Od(...n){let t="THREE."+n.shift();fo?fo("log",t,...n):console.log(t,...n)}function dg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=dg(n);let t="THREE."+n.shift();if(fo)fo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Qt(...n){n=dg(n);let t="THREE."+n.shift();if(fo)fo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ha(...n){let t=n.join(" ");t in tm||(tm[t]=!0,qt(...n))}function fg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var pg={[Gl]:Gl,[Wl]:ql,[$l]:$l,[uo]:Xl,[Hl]:Hl,[ql]:Wl,[Yl]:Yl,[Xl]:uo},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],em=1234567,da=Math.PI/180,po=180/Math.PI;function Eo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]+"-"+Fn[t&255]+Fn[t>>8&255]+"-"+Fn[t>>16&15|64]+Fn[t>>24&255]+"-"+Fn[e&63|128]+Fn[e>>8&255]+"-"+Fn[e>>16&255]+Fn[e>>24&255]+Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]).toLowerCase()}function pe(n,t,e){return Math.max(t,Math.min(e,n))}function Ud(n,t){return(n%t+t)%t}function Hv(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Wv(n,t,e){return n!==t?(e-n)/(t-n):0}function fa(n,t,e){return(1-e)*n+e*t}function $v(n,t,e,i){return fa(n,t,1-Math.exp(-e*i))}function Xv(n,t=1){return t-Math.abs(Ud(n,t*2)-t)}function qv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Yv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Zv(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Kv(n,t){return n+Math.random()*(t-n)}function Jv(n){return n*(.5-Math.random())}function jv(n){n!==void 0&&(em=n);let t=em+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Qv(n){return n*da}function tb(n){return n*po}function eb(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function nb(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function kd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ib(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Fd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function mg(n,t){if(t.constructor===Float32Array)return n;let e=Fd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function gg(n,t){if(t.constructor===Float32Array)return n;let e=Fd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Bd={DEG2RAD:da,RAD2DEG:po,generateUUID:Eo,clamp:pe,euclideanModulo:Ud,mapLinear:Hv,inverseLerp:Wv,lerp:fa,damp:$v,pingpong:Xv,smoothstep:qv,smootherstep:Yv,randInt:Zv,randFloat:Kv,randFloatSpread:Jv,seededRandom:jv,degToRad:Qv,radToDeg:tb,isPowerOfTwo:eb,ceilPowerOfTwo:nb,floorPowerOfTwo:kd,setQuaternionFromProperEuler:ib,normalize:gg,denormalize:mg},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=pe(this.x,t.x,e.x),this.y=pe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=pe(this.x,t,e),this.y=pe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(pe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ui=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==p){let g=l*d+c*f+u*p+h*x;g<0&&(d=-d,f=-f,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),b=Math.sin(_);m=Math.sin(m*_)/b,a=Math.sin(a*_)/b,l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+x*a}else{l=l*m+d*a,c=c*m+f*a,u=u*m+p*a,h=h*m+x*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(pe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=pe(this.x,t.x,e.x),this.y=pe(this.y,t.y,e.y),this.z=pe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=pe(this.x,t,e),this.y=pe(this.y,t,e),this.z=pe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Dh.copy(this).projectOnVector(t),this.sub(Dh)}reflect(t){return this.sub(Dh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(pe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dh=new V,nm=new ui,te=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],x=s[0],g=s[3],m=s[6],_=s[1],b=s[4],v=s[7],E=s[2],A=s[5],y=s[8];return r[0]=o*x+a*_+l*E,r[3]=o*g+a*b+l*A,r[6]=o*m+a*v+l*y,r[1]=c*x+u*_+h*E,r[4]=c*g+u*b+h*A,r[7]=c*m+u*v+h*y,r[2]=d*x+f*_+p*E,r[5]=d*g+f*b+p*A,r[8]=d*m+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=h*x,t[1]=(s*c-u*i)*x,t[2]=(a*i-s*o)*x,t[3]=d*x,t[4]=(u*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ha("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Oh.makeScale(t,e)),this}rotate(t){return ha("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Oh.makeRotation(-t)),this}translate(t,e){return ha("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Oh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Oh=new te,im=new te().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sm=new te().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function sb(){let n={enabled:!0,workingColorSpace:ma,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ce&&(s.r=gs(s.r),s.g=gs(s.g),s.b=gs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(s.r=co(s.r),s.g=co(s.g),s.b=co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?ga:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ma]:{primaries:t,whitePoint:i,transfer:ga,toXYZ:im,fromXYZ:sm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:li},outputColorSpaceConfig:{drawingBufferColorSpace:li}},[li]:{primaries:t,whitePoint:i,transfer:Ce,toXYZ:im,fromXYZ:sm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:li}}}),n}var _e=sb();function gs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function co(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Zr,jl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Zr===void 0&&(Zr=xa("canvas")),Zr.width=t.width,Zr.height=t.height;let s=Zr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Zr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=xa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=gs(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(gs(e[i]/255)*255):e[i]=gs(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},rb=0,mo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:rb++}),this.uuid=Eo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Uh(s[o].image)):r.push(Uh(s[o]))}else r=Uh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Uh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?jl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var ob=0,kh=new V,Qn=class n extends Ii{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ji,s=Ji,r=Zn,o=ws,a=Di,l=ti,c=n.DEFAULT_ANISOTROPY,u=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ob++}),this.uuid=Eo(),this.name="",this.source=new mo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new te,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(kh).x}get height(){return this.source.getSize(kh).y}get depth(){return this.source.getSize(kh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Sd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Zl:t.x=t.x-Math.floor(t.x);break;case Ji:t.x=t.x<0?0:1;break;case Kl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Zl:t.y=t.y-Math.floor(t.y);break;case Ji:t.y=t.y<0?0:1;break;case Kl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=Sd;Qn.DEFAULT_ANISOTROPY=1;var Fe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,v=(f+1)/2,E=(m+1)/2,A=(u+d)/4,y=(h+x)/4,M=(p+g)/4;return b>v&&b>E?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=A/i,r=y/i):v>E?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=A/s,r=M/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=y/r,s=M/r),this.set(i,s,r,e),this}let _=Math.sqrt((g-p)*(g-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(h-x)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=pe(this.x,t.x,e.x),this.y=pe(this.y,t.y,e.y),this.z=pe(this.z,t.z,e.z),this.w=pe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=pe(this.x,t,e),this.y=pe(this.y,t,e),this.z=pe(this.z,t,e),this.w=pe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ql=class extends Ii{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Fe(0,0,t,e),this.scissorTest=!1,this.viewport=new Fe(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new mo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},hi=class extends Ql{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},_a=class extends Qn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var tc=class extends Qn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=Ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ae=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,g)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,x,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Kr.setFromMatrixColumn(t,0).length(),r=1/Kr.setFromMatrixColumn(t,1).length(),o=1/Kr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,x=c*h;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,x=c*h;e[0]=d-x*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*h,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*u,e[4]=x-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-x*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+x,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=x*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(ab,t,lb)}lookAt(t,e,i){let s=this.elements;return oi.subVectors(t,e),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Bs.crossVectors(i,oi),Bs.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Bs.crossVectors(i,oi)),Bs.normalize(),xl.crossVectors(oi,Bs),s[0]=Bs.x,s[4]=xl.x,s[8]=oi.x,s[1]=Bs.y,s[5]=xl.y,s[9]=oi.y,s[2]=Bs.z,s[6]=xl.z,s[10]=oi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],x=i[6],g=i[10],m=i[14],_=i[3],b=i[7],v=i[11],E=i[15],A=s[0],y=s[4],M=s[8],I=s[12],L=s[1],C=s[5],D=s[9],k=s[13],N=s[2],B=s[6],W=s[10],H=s[14],st=s[3],Y=s[7],Q=s[11],it=s[15];return r[0]=o*A+a*L+l*N+c*st,r[4]=o*y+a*C+l*B+c*Y,r[8]=o*M+a*D+l*W+c*Q,r[12]=o*I+a*k+l*H+c*it,r[1]=u*A+h*L+d*N+f*st,r[5]=u*y+h*C+d*B+f*Y,r[9]=u*M+h*D+d*W+f*Q,r[13]=u*I+h*k+d*H+f*it,r[2]=p*A+x*L+g*N+m*st,r[6]=p*y+x*C+g*B+m*Y,r[10]=p*M+x*D+g*W+m*Q,r[14]=p*I+x*k+g*H+m*it,r[3]=_*A+b*L+v*N+E*st,r[7]=_*y+b*C+v*B+E*Y,r[11]=_*M+b*D+v*W+E*Q,r[15]=_*I+b*k+v*H+E*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],x=t[7],g=t[11],m=t[15],_=l*f-c*d,b=a*f-c*h,v=a*d-l*h,E=o*f-c*u,A=o*d-l*u,y=o*h-a*u;return e*(x*_-g*b+m*v)-i*(p*_-g*E+m*A)+s*(p*b-x*E+m*y)-r*(p*v-x*A+g*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],x=t[13],g=t[14],m=t[15],_=e*a-i*o,b=e*l-s*o,v=e*c-r*o,E=i*l-s*a,A=i*c-r*a,y=s*c-r*l,M=u*x-h*p,I=u*g-d*p,L=u*m-f*p,C=h*g-d*x,D=h*m-f*x,k=d*m-f*g,N=_*k-b*D+v*C+E*L-A*I+y*M;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/N;return t[0]=(a*k-l*D+c*C)*B,t[1]=(s*D-i*k-r*C)*B,t[2]=(x*y-g*A+m*E)*B,t[3]=(d*A-h*y-f*E)*B,t[4]=(l*L-o*k-c*I)*B,t[5]=(e*k-s*L+r*I)*B,t[6]=(g*v-p*y-m*b)*B,t[7]=(u*y-d*v+f*b)*B,t[8]=(o*D-a*L+c*M)*B,t[9]=(i*L-e*D-r*M)*B,t[10]=(p*A-x*v+m*_)*B,t[11]=(h*v-u*A-f*_)*B,t[12]=(a*I-o*C-l*M)*B,t[13]=(e*C-i*I+s*M)*B,t[14]=(x*b-p*E-g*_)*B,t[15]=(u*E-h*b+d*_)*B,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,x=o*u,g=o*h,m=a*h,_=l*c,b=l*u,v=l*h,E=i.x,A=i.y,y=i.z;return s[0]=(1-(x+m))*E,s[1]=(f+v)*E,s[2]=(p-b)*E,s[3]=0,s[4]=(f-v)*A,s[5]=(1-(d+m))*A,s[6]=(g+_)*A,s[7]=0,s[8]=(p+b)*y,s[9]=(g-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Kr.set(s[0],s[1],s[2]).length(),a=Kr.set(s[4],s[5],s[6]).length(),l=Kr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,u=1/a,h=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=h,Ci.elements[9]*=h,Ci.elements[10]*=h,e.setFromRotationMatrix(Ci),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===vi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ho)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===vi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===ho)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Kr=new V,Ci=new ae,ab=new V(0,0,0),lb=new V(1,1,1),Bs=new V,xl=new V,oi=new V,rm=new ae,om=new ui,_s=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(pe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-pe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(pe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-pe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(pe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-pe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return rm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return om.setFromEuler(this),this.setFromQuaternion(om,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};_s.DEFAULT_ORDER="XYZ";var go=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},cb=0,am=new V,Jr=new ui,hs=new ae,_l=new V,sa=new V,ub=new V,hb=new ui,lm=new V(1,0,0),cm=new V(0,1,0),um=new V(0,0,1),hm={type:"added"},db={type:"removed"},jr={type:"childadded",child:null},Fh={type:"childremoved",child:null},Un=class n extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:cb++}),this.uuid=Eo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new V,e=new _s,i=new ui,s=new V(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ae},normalMatrix:{value:new te}}),this.matrix=new ae,this.matrixWorld=new ae,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new go,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Jr.setFromAxisAngle(t,e),this.quaternion.multiply(Jr),this}rotateOnWorldAxis(t,e){return Jr.setFromAxisAngle(t,e),this.quaternion.premultiply(Jr),this}rotateX(t){return this.rotateOnAxis(lm,t)}rotateY(t){return this.rotateOnAxis(cm,t)}rotateZ(t){return this.rotateOnAxis(um,t)}translateOnAxis(t,e){return am.copy(t).applyQuaternion(this.quaternion),this.position.add(am.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lm,t)}translateY(t){return this.translateOnAxis(cm,t)}translateZ(t){return this.translateOnAxis(um,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(hs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?_l.copy(t):_l.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),sa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?hs.lookAt(sa,_l,this.up):hs.lookAt(_l,sa,this.up),this.quaternion.setFromRotationMatrix(hs),s&&(hs.extractRotation(s.matrixWorld),Jr.setFromRotationMatrix(hs),this.quaternion.premultiply(Jr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(hm),jr.child=t,this.dispatchEvent(jr),jr.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(db),Fh.child=t,this.dispatchEvent(Fh),Fh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),hs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),hs.multiply(t.parent.matrixWorld)),t.applyMatrix4(hs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(hm),jr.child=t,this.dispatchEvent(jr),jr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(sa,t,ub),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(sa,hb,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Un.DEFAULT_UP=new V(0,1,0);Un.DEFAULT_MATRIX_AUTO_UPDATE=!0;Un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ln=class extends Un{constructor(){super(),this.isGroup=!0,this.type="Group"}},fb={type:"move"},xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ln,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ln,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ln,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,i),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(fb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ln;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},xg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zs={h:0,s:0,l:0},yl={h:0,s:0,l:0};function Bh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var $t=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=li){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=i,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=_e.workingColorSpace){if(t=Ud(t,1),e=pe(e,0,1),i=pe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Bh(o,r,t+1/3),this.g=Bh(o,r,t),this.b=Bh(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=li){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=li){let i=xg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=gs(t.r),this.g=gs(t.g),this.b=gs(t.b),this}copyLinearToSRGB(t){return this.r=co(t.r),this.g=co(t.g),this.b=co(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=li){return _e.workingToColorSpace(Bn.copy(this),t),Math.round(pe(Bn.r*255,0,255))*65536+Math.round(pe(Bn.g*255,0,255))*256+Math.round(pe(Bn.b*255,0,255))}getHexString(t=li){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(Bn.copy(this),e);let i=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(Bn.copy(this),e),t.r=Bn.r,t.g=Bn.g,t.b=Bn.b,t}getStyle(t=li){_e.workingToColorSpace(Bn.copy(this),t);let e=Bn.r,i=Bn.g,s=Bn.b;return t!==li?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(zs),this.setHSL(zs.h+t,zs.s+e,zs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(zs),t.getHSL(yl);let i=fa(zs.h,yl.h,e),s=fa(zs.s,yl.s,e),r=fa(zs.l,yl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new $t;$t.NAMES=xg;var ya=class extends Un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new _s,this.environmentIntensity=1,this.environmentRotation=new _s,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new V,ds=new V,zh=new V,fs=new V,Qr=new V,to=new V,dm=new V,Vh=new V,Gh=new V,Hh=new V,Wh=new Fe,$h=new Fe,Xh=new Fe,Ki=class n{constructor(t=new V,e=new V,i=new V){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ri.subVectors(s,e),ds.subVectors(i,e),zh.subVectors(t,e);let o=Ri.dot(Ri),a=Ri.dot(ds),l=Ri.dot(zh),c=ds.dot(ds),u=ds.dot(zh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,fs)===null?!1:fs.x>=0&&fs.y>=0&&fs.x+fs.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,fs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,fs.x),l.addScaledVector(o,fs.y),l.addScaledVector(a,fs.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Wh.setScalar(0),$h.setScalar(0),Xh.setScalar(0),Wh.fromBufferAttribute(t,e),$h.fromBufferAttribute(t,i),Xh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Wh,r.x),o.addScaledVector($h,r.y),o.addScaledVector(Xh,r.z),o}static isFrontFacing(t,e,i,s){return Ri.subVectors(i,e),ds.subVectors(t,e),Ri.cross(ds).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),ds.subVectors(this.a,this.b),Ri.cross(ds).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Qr.subVectors(s,i),to.subVectors(r,i),Vh.subVectors(t,i);let l=Qr.dot(Vh),c=to.dot(Vh);if(l<=0&&c<=0)return e.copy(i);Gh.subVectors(t,s);let u=Qr.dot(Gh),h=to.dot(Gh);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Qr,o);Hh.subVectors(t,r);let f=Qr.dot(Hh),p=to.dot(Hh);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(to,a);let g=u*p-f*h;if(g<=0&&h-u>=0&&f-p>=0)return dm.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(dm,a);let m=1/(g+x+d);return o=x*m,a=d*m,e.copy(i).addScaledVector(Qr,o).addScaledVector(to,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ji=class{constructor(t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),vl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),vl.copy(i.boundingBox)),vl.applyMatrix4(t.matrixWorld),this.union(vl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ra),bl.subVectors(this.max,ra),eo.subVectors(t.a,ra),no.subVectors(t.b,ra),io.subVectors(t.c,ra),Vs.subVectors(no,eo),Gs.subVectors(io,no),xr.subVectors(eo,io);let e=[0,-Vs.z,Vs.y,0,-Gs.z,Gs.y,0,-xr.z,xr.y,Vs.z,0,-Vs.x,Gs.z,0,-Gs.x,xr.z,0,-xr.x,-Vs.y,Vs.x,0,-Gs.y,Gs.x,0,-xr.y,xr.x,0];return!qh(e,eo,no,io,bl)||(e=[1,0,0,0,1,0,0,0,1],!qh(e,eo,no,io,bl))?!1:(Sl.crossVectors(Vs,Gs),e=[Sl.x,Sl.y,Sl.z],qh(e,eo,no,io,bl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ps),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ps=[new V,new V,new V,new V,new V,new V,new V,new V],Pi=new V,vl=new ji,eo=new V,no=new V,io=new V,Vs=new V,Gs=new V,xr=new V,ra=new V,bl=new V,Sl=new V,_r=new V;function qh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){_r.fromArray(n,r);let a=s.x*Math.abs(_r.x)+s.y*Math.abs(_r.y)+s.z*Math.abs(_r.z),l=t.dot(_r),c=e.dot(_r),u=i.dot(_r);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var mn=new V,Ml=new Yt,pb=0,an=class extends Ii{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:pb++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=ug,this.updateRanges=[],this.gpuType=Si,this.version=0,this._normalizationScale=t!==void 0?Fd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Ml.fromBufferAttribute(this,e),Ml.applyMatrix3(t),this.setXY(e,Ml.x,Ml.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):mg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):gg(t,this.array)}};var va=class extends an{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ba=class extends an{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var sn=class extends an{constructor(t,e,i){super(new Float32Array(t),e,i)}},mb=new ji,oa=new V,Yh=new V,ys=class{constructor(t=new V,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):mb.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;oa.subVectors(t,this.center);let e=oa.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(oa,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Yh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(oa.copy(t.center).add(Yh)),this.expandByPoint(oa.copy(t.center).sub(Yh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},gb=0,yi=new ae,Zh=new Un,so=new V,ai=new ji,aa=new ji,In=new V,vn=class n extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:gb++}),this.uuid=Eo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Vv(t)?ba:va)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new te().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return yi.makeRotationFromQuaternion(t),this.applyMatrix4(yi),this}rotateX(t){return yi.makeRotationX(t),this.applyMatrix4(yi),this}rotateY(t){return yi.makeRotationY(t),this.applyMatrix4(yi),this}rotateZ(t){return yi.makeRotationZ(t),this.applyMatrix4(yi),this}translate(t,e,i){return yi.makeTranslation(t,e,i),this.applyMatrix4(yi),this}scale(t,e,i){return yi.makeScale(t,e,i),this.applyMatrix4(yi),this}lookAt(t){return Zh.lookAt(t),Zh.updateMatrix(),this.applyMatrix4(Zh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(so).negate(),this.translate(so.x,so.y,so.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new sn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ji);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ys);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(t){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];aa.setFromBufferAttribute(a),this.morphTargetsRelative?(In.addVectors(ai.min,aa.min),ai.expandByPoint(In),In.addVectors(ai.max,aa.max),ai.expandByPoint(In)):(ai.expandByPoint(aa.min),ai.expandByPoint(aa.max))}ai.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)In.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(In));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)In.fromBufferAttribute(a,c),l&&(so.fromBufferAttribute(t,c),In.add(so)),s=Math.max(s,i.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new an(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new V,l[I]=new V;let u=new V,h=new V,d=new V,f=new Yt,p=new Yt,x=new Yt,g=new V,m=new V;function _(I,L,C){c[I]=c[L]=c[C]=1,u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,C),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,L),x.fromBufferAttribute(r,C),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let D=1/(p.x*x.y-x.x*p.y);isFinite(D)&&(g.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(D),m.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(D),a[I].add(g),a[L].add(g),a[C].add(g),l[I].add(m),l[L].add(m),l[C].add(m))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let I=0,L=b.length;I<L;++I){let C=b[I],D=C.start,k=C.count;for(let N=D,B=D+k;N<B;N+=3)_(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let v=new V,E=new V,A=new V,y=new V;function M(I){A.fromBufferAttribute(s,I),y.copy(A);let L=a[I];v.copy(L),v.sub(A.multiplyScalar(A.dot(L))).normalize(),E.crossVectors(y,L);let D=E.dot(l[I])<0?-1:1;o.setXYZW(I,v.x,v.y,v.z,D)}for(let I=0,L=i.count;I<L;++I)c[I]&&M(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new an(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,u=new V,h=new V;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)In.fromBufferAttribute(t,e),In.normalize(),t.setXYZ(e,In.x,In.y,In.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let m=0;m<u;m++)d[p++]=c[f++]}return new an(d,u,h)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Kh=new V,xb=new V,_b=new te,ci=class{constructor(t=new V(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Kh.subVectors(i,e).cross(xb.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Kh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||_b.getNormalMatrix(t),s=this.coplanarPoint(Kh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},yb=0,vs=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:yb++}),this.uuid=Eo(),this.name="",this.type="Material",this.blending=Mo,this.side=js,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=fd,this.blendDst=pd,this.blendEquation=Ar,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new $t(0,0,0),this.blendAlpha=0,this.depthFunc=uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=sg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Vl,this.stencilZFail=Vl,this.stencilZPass=Vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new $t().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ci().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ms=new V,Jh=new V,wl=new V,Al=new V,Ws=class{constructor(t=new V,e=new V(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ms)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ms.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ms.copy(this.origin).addScaledVector(this.direction,e),ms.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Jh.copy(t).add(e).multiplyScalar(.5),wl.copy(e).sub(t).normalize(),Al.copy(this.origin).sub(Jh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(wl),a=Al.dot(this.direction),l=-Al.dot(wl),c=Al.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Jh).addScaledVector(wl,d),f}intersectSphere(t,e){if(t.radius<0)return null;ms.subVectors(t.center,this.origin);let i=ms.dot(this.direction),s=ms.dot(ms)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,ms)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,g=e.z-o.z,m=i.x-o.x,_=i.y-o.y,b=i.z-o.z,v=Math.abs(l),E=Math.abs(c),A=Math.abs(u),y,M,I,L,C,D,k,N,B,W,H,st;if(v>=E&&v>=A?(I=l,D=h,B=p,st=m,l>=0?(y=c,M=u,L=d,C=f,k=x,N=g,W=_,H=b):(y=u,M=c,L=f,C=d,k=g,N=x,W=b,H=_)):E>=A?(I=c,D=d,B=x,st=_,c>=0?(y=u,M=l,L=f,C=h,k=g,N=p,W=b,H=m):(y=l,M=u,L=h,C=f,k=p,N=g,W=m,H=b)):(I=u,D=f,B=g,st=b,u>=0?(y=l,M=c,L=h,C=d,k=p,N=x,W=m,H=_):(y=c,M=l,L=d,C=h,k=x,N=p,W=_,H=m)),I===0)return null;let Y=y/I,Q=M/I,it=1/I,ft=L-Y*D,dt=C-Q*D,tt=k-Y*B,ht=N-Q*B,gt=W-Y*st,St=H-Q*st,Mt=gt*ht-St*tt,Ht=ft*St-dt*gt,se=tt*dt-ht*ft;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Vt=Mt+Ht+se;if(Vt===0)return null;let he=it*(Mt*D+Ht*B+se*st);return(Vt>0?he<0:he>0)?null:this.at(he/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},bs=class extends vs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new $t(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _s,this.combine=vc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fm=new ae,yr=new Ws,El=new ys,pm=new V,Tl=new V,Cl=new V,Rl=new V,jh=new V,Pl=new V,mm=new V,Il=new V,gn=class extends Un{constructor(t=new vn,e=new bs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Pl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(jh.fromBufferAttribute(h,t),o?Pl.addScaledVector(jh,u):Pl.addScaledVector(jh.sub(e),u))}e.add(Pl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),El.copy(i.boundingSphere),El.applyMatrix4(r),yr.copy(t.ray).recast(t.near),!(El.containsPoint(yr.origin)===!1&&(yr.intersectSphere(El,pm)===null||yr.origin.distanceToSquared(pm)>(t.far-t.near)**2))&&(fm.copy(r).invert(),yr.copy(t.ray).applyMatrix4(fm),!(i.boundingBox!==null&&yr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,yr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),b=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,E=b;v<E;v+=3){let A=a.getX(v),y=a.getX(v+1),M=a.getX(v+2);s=Ll(this,m,t,i,c,u,h,A,y,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let _=a.getX(g),b=a.getX(g+1),v=a.getX(g+2);s=Ll(this,o,t,i,c,u,h,_,b,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],_=Math.max(g.start,f.start),b=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let v=_,E=b;v<E;v+=3){let A=v,y=v+1,M=v+2;s=Ll(this,m,t,i,c,u,h,A,y,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let _=g,b=g+1,v=g+2;s=Ll(this,o,t,i,c,u,h,_,b,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function vb(n,t,e,i,s,r,o,a){let l;if(t.side===Kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===js,a),l===null)return null;Il.copy(a),Il.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Il);return c<e.near||c>e.far?null:{distance:c,point:Il.clone(),object:n}}function Ll(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Tl),n.getVertexPosition(l,Cl),n.getVertexPosition(c,Rl);let u=vb(n,t,e,i,Tl,Cl,Rl,mm);if(u){let h=new V;Ki.getBarycoord(mm,Tl,Cl,Rl,h),s&&(u.uv=Ki.getInterpolatedAttribute(s,a,l,c,h,new Yt)),r&&(u.uv1=Ki.getInterpolatedAttribute(r,a,l,c,h,new Yt)),o&&(u.normal=Ki.getInterpolatedAttribute(o,a,l,c,h,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new V,materialIndex:0};Ki.getNormal(Tl,Cl,Rl,d.normal),u.face=d,u.barycoord=h}return u}var Sa=class extends Qn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Nn,u=Nn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ma=class extends an{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},ro=new ae,gm=new ae,Nl=[],xm=new ji,bb=new ae,la=new gn,ca=new ys,di=class extends gn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Ma(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,bb)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new ji),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ro),xm.copy(t.boundingBox).applyMatrix4(ro),this.boundingBox.union(xm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new ys),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,ro),ca.copy(t.boundingSphere).applyMatrix4(ro),this.boundingSphere.union(ca)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(la.geometry=this.geometry,la.material=this.material,la.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ca.copy(this.boundingSphere),ca.applyMatrix4(i),t.ray.intersectsSphere(ca)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ro),gm.multiplyMatrices(i,ro),la.matrixWorld=gm,la.raycast(t,Nl);for(let o=0,a=Nl.length;o<a;o++){let l=Nl[o];l.instanceId=r,l.object=this,e.push(l)}Nl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Ma(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Sa(new Float32Array(s*this.count),s,this.count,Tc,Si));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},vr=new ys,Sb=new Yt(.5,.5),Dl=new V,$s=class{constructor(t=new ci,e=new ci,i=new ci,s=new ci,r=new ci,o=new ci){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=vi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],g=r[10],m=r[11],_=r[12],b=r[13],v=r[14],E=r[15];if(s[0].setComponents(c-o,f-u,m-p,E-_).normalize(),s[1].setComponents(c+o,f+u,m+p,E+_).normalize(),s[2].setComponents(c+a,f+h,m+x,E+b).normalize(),s[3].setComponents(c-a,f-h,m-x,E-b).normalize(),i)s[4].setComponents(l,d,g,v).normalize(),s[5].setComponents(c-l,f-d,m-g,E-v).normalize();else if(s[4].setComponents(c-l,f-d,m-g,E-v).normalize(),e===vi)s[5].setComponents(c+l,f+d,m+g,E+v).normalize();else if(e===ho)s[5].setComponents(l,d,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),vr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),vr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(vr)}intersectsSprite(t){vr.center.set(0,0,0);let e=Sb.distanceTo(t.center);return vr.radius=.7071067811865476+e,vr.applyMatrix4(t.matrixWorld),this.intersectsSphere(vr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Dl.x=s.normal.x>0?t.max.x:t.min.x,Dl.y=s.normal.y>0?t.max.y:t.min.y,Dl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Dl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},_m=new ae,ec=class n{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];_m.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new $s),i[s].setFromProjectionMatrix(_m,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new $s),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Xs=class extends vs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new $t(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},nc=new V,ic=new V,ym=new ae,ua=new Ws,Ol=new ys,Qh=new V,vm=new V,sc=class extends Un{constructor(t=new vn,e=new Xs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)nc.fromBufferAttribute(e,s-1),ic.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=nc.distanceTo(ic);t.setAttribute("lineDistance",new sn(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ol.copy(i.boundingSphere),Ol.applyMatrix4(s),Ol.radius+=r,t.ray.intersectsSphere(Ol)===!1)return;ym.copy(s).invert(),ua.copy(t.ray).applyMatrix4(ym);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=u.getX(x),_=u.getX(x+1),b=Ul(this,t,ua,l,m,_,x);b&&e.push(b)}if(this.isLineLoop){let x=u.getX(p-1),g=u.getX(f),m=Ul(this,t,ua,l,x,g,p-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=Ul(this,t,ua,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=Ul(this,t,ua,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ul(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(nc.fromBufferAttribute(a,s),ic.fromBufferAttribute(a,r),e.distanceSqToSegment(nc,ic,Qh,vm)>i)return;Qh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Qh);if(!(c<t.near||c>t.far))return{distance:c,point:vm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var bm=new V,Sm=new V,br=class extends sc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)bm.fromBufferAttribute(e,s),Sm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+bm.distanceTo(Sm);t.setAttribute("lineDistance",new sn(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var wa=class extends Qn{constructor(t=[],e=Er,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ss=class extends Qn{constructor(t,e,i=Li,s,r,o,a=Nn,l=Nn,c,u=xs,h=1){if(u!==xs&&u!==As)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new mo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Aa=class extends Ss{constructor(t,e=Li,i=Er,s,r,o=Nn,a=Nn,l,c=xs){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ea=class extends Qn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},_o=class n extends vn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new sn(c,3)),this.setAttribute("normal",new sn(u,3)),this.setAttribute("uv",new sn(h,2));function p(x,g,m,_,b,v,E,A,y,M,I){let L=v/y,C=E/M,D=v/2,k=E/2,N=A/2,B=y+1,W=M+1,H=0,st=0,Y=new V;for(let Q=0;Q<W;Q++){let it=Q*C-k;for(let ft=0;ft<B;ft++){let dt=ft*L-D;Y[x]=dt*_,Y[g]=it*b,Y[m]=N,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[g]=0,Y[m]=A>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(ft/y),h.push(1-Q/M),H+=1}}for(let Q=0;Q<M;Q++)for(let it=0;it<y;it++){let ft=d+it+B*Q,dt=d+it+B*(Q+1),tt=d+(it+1)+B*(Q+1),ht=d+(it+1)+B*Q;l.push(ft,dt,ht),l.push(dt,tt,ht),st+=6}a.addGroup(f,st,I),f+=st,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var bi=class n extends vn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],g=i/2,m=0;_(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new sn(h,3)),this.setAttribute("normal",new sn(d,3)),this.setAttribute("uv",new sn(f,2));function _(){let v=new V,E=new V,A=0,y=(e-t)/i;for(let M=0;M<=r;M++){let I=[],L=M/r,C=L*(e-t)+t;for(let D=0;D<=s;D++){let k=D/s,N=k*l+a,B=Math.sin(N),W=Math.cos(N);E.x=C*B,E.y=-L*i+g,E.z=C*W,h.push(E.x,E.y,E.z),v.set(B,y,W).normalize(),d.push(v.x,v.y,v.z),f.push(k,1-L),I.push(p++)}x.push(I)}for(let M=0;M<s;M++)for(let I=0;I<r;I++){let L=x[I][M],C=x[I+1][M],D=x[I+1][M+1],k=x[I][M+1];(t>0||I!==0)&&(u.push(L,C,k),A+=3),(e>0||I!==r-1)&&(u.push(C,D,k),A+=3)}c.addGroup(m,A,0),m+=A}function b(v){let E=p,A=new Yt,y=new V,M=0,I=v===!0?t:e,L=v===!0?1:-1;for(let D=1;D<=s;D++)h.push(0,g*L,0),d.push(0,L,0),f.push(.5,.5),p++;let C=p;for(let D=0;D<=s;D++){let N=D/s*l+a,B=Math.cos(N),W=Math.sin(N);y.x=I*W,y.y=g*L,y.z=I*B,h.push(y.x,y.y,y.z),d.push(0,L,0),A.x=B*.5+.5,A.y=W*.5*L+.5,f.push(A.x,A.y),p++}for(let D=0;D<s;D++){let k=E+D,N=C+D;v===!0?u.push(N,N+1,k):u.push(N+1,N,k),M+=3}c.addGroup(m,M,v===!0?1:2),m+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Sr=class n extends bi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Ta=class n extends vn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],x=[],g=[];for(let m=0;m<u;m++){let _=m*d-o;for(let b=0;b<c;b++){let v=b*h-r;p.push(v,-_,0),x.push(0,0,1),g.push(b/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let b=_+c*m,v=_+c*(m+1),E=_+1+c*(m+1),A=_+1+c*m;f.push(b,v,A),f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new sn(p,3)),this.setAttribute("normal",new sn(x,3)),this.setAttribute("uv",new sn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var yo=class n extends vn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new V,d=new V,f=[],p=[],x=[],g=[];for(let m=0;m<=i;m++){let _=[],b=m/i,v=o+b*a,E=t*Math.cos(v),A=Math.sqrt(t*t-E*E),y=0;m===0&&o===0?y=.5/e:m===i&&l===Math.PI&&(y=-.5/e);for(let M=0;M<=e;M++){let I=M/e,L=s+I*r;h.x=-A*Math.cos(L),h.y=E,h.z=A*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),g.push(I+y,1-b),_.push(c++)}u.push(_)}for(let m=0;m<i;m++)for(let _=0;_<e;_++){let b=u[m][_+1],v=u[m][_],E=u[m+1][_],A=u[m+1][_+1];(m!==0||o>0)&&f.push(b,v,A),(m!==i-1||l<Math.PI)&&f.push(v,E,A)}this.setIndex(f),this.setAttribute("position",new sn(p,3)),this.setAttribute("normal",new sn(x,3)),this.setAttribute("uv",new sn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function Cr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Mm(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Mm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Vn(n){let t={};for(let e=0;e<n.length;e++){let i=Cr(n[e]);for(let s in i)t[s]=i[s]}return t}function Mm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Mb(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function zd(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var _g={clone:Cr,merge:Vn},wb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ab=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Qi=class extends vs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=wb,this.fragmentShader=Ab,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Cr(t.uniforms),this.uniformsGroups=Mb(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new $t().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new V().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Fe().fromArray(s.value);break;case"m3":this.uniforms[i].value=new te().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ae().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},rc=class extends Qi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ms=class extends vs{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new $t(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new $t(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=au,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _s,this.combine=vc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},oc=class extends vs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ng,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ac=class extends vs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function oo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function kl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var qs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},lc=class extends qs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:nd,endingEnd:nd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case id:r=t,a=2*e-i;break;case sd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case id:o=t,l=2*i-e;break;case sd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),x=p*p,g=x*p,m=-d*g+2*d*x-d*p,_=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*p+1,b=(-1-f)*g+(1.5+f)*x+.5*p,v=f*g-f*x;for(let E=0;E!==a;++E)r[E]=m*o[u+E]+_*o[c+E]+b*o[l+E]+v*o[h+E];return r}},cc=class extends qs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},uc=class extends qs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},hc=class extends qs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=f*d+p*2,_=h[m],b=h[m+1],v=t*d+p*2,E=u[v],A=u[v+1],y=Tb(i,e,_,E,s);r[p]=yg(y,x,b,A,g)}return r}};function yg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Eb(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Tb(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=yg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Eb(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=oo(e,this.TimeBufferType),this.values=oo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:oo(t.times,Array),values:oo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),kl(t.settings)&&(i.settings={inTangents:oo(t.settings.inTangents,Array),outTangents:oo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new uc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new cc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new lc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new hc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case pa:e=this.InterpolantFactoryMethodDiscrete;break;case Jl:e=this.InterpolantFactoryMethodLinear;break;case zl:e=this.InterpolantFactoryMethodSmooth;break;case ed:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return pa;case this.InterpolantFactoryMethodLinear:return Jl;case this.InterpolantFactoryMethodSmooth:return zl;case this.InterpolantFactoryMethodBezier:return ed}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;kl(this.settings)&&(wm(this.settings.inTangents,t),wm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;kl(this.settings)&&(Am(this.settings.inTangents,t),Am(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Qt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Qt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Gv(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===zl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let x=e[h+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,kl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function wm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Am(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=Jl;var Ys=class extends fi{constructor(t,e,i){super(t,e,i)}};Ys.prototype.ValueTypeName="bool";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=pa;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var dc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};dc.prototype.ValueTypeName="color";var fc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};fc.prototype.ValueTypeName="number";var pc=class extends qs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ca=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new pc(this.times,this.values,this.getValueSize(),t)}};Ca.prototype.ValueTypeName="quaternion";Ca.prototype.InterpolantFactoryMethodSmooth=void 0;var Zs=class extends fi{constructor(t,e,i){super(t,e,i)}};Zs.prototype.ValueTypeName="string";Zs.prototype.ValueBufferType=Array;Zs.prototype.DefaultInterpolation=pa;Zs.prototype.InterpolantFactoryMethodLinear=void 0;Zs.prototype.InterpolantFactoryMethodSmooth=void 0;var mc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};mc.prototype.ValueTypeName="vector";var gc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},vg=new gc,xc=class{constructor(t){this.manager=t!==void 0?t:vg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};xc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ra=class extends Un{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new $t(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Pa=class extends Ra{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new $t(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},td=new ae,Em=new V,Tm=new V,_c=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new ae,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new $s,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new Fe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Em.setFromMatrixPosition(t.matrixWorld),e.position.copy(Em),Tm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Tm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){td.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(td,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===ho||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(td)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Fl=new V,Bl=new ui,Zi=new V,Ia=class extends Un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ae,this.projectionMatrix=new ae,this.projectionMatrixInverse=new ae,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Fl,Bl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fl,Bl,Zi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Fl,Bl,Zi),Zi.x===1&&Zi.y===1&&Zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fl,Bl,Zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Hs=new V,Cm=new Yt,Rm=new Yt,Yn=class extends Ia{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=po*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(da*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return po*2*Math.atan(Math.tan(da*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Hs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Hs.x,Hs.y).multiplyScalar(-t/Hs.z),Hs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Hs.x,Hs.y).multiplyScalar(-t/Hs.z)}getViewSize(t,e){return this.getViewBounds(t,Cm,Rm),e.subVectors(Rm,Cm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(da*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var La=class extends Ia{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},rd=class extends _c{constructor(){super(new La(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Na=class extends Ra{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Un.DEFAULT_UP),this.updateMatrix(),this.target=new Un,this.shadow=new rd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var ao=-90,lo=1,vo=class extends Un{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Yn(ao,lo,t,e);s.layers=this.layers,this.add(s);let r=new Yn(ao,lo,t,e);r.layers=this.layers,this.add(r);let o=new Yn(ao,lo,t,e);o.layers=this.layers,this.add(o);let a=new Yn(ao,lo,t,e);a.layers=this.layers,this.add(a);let l=new Yn(ao,lo,t,e);l.layers=this.layers,this.add(l);let c=new Yn(ao,lo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ho)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},yc=class extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Vd="\\[\\]\\.:\\/",Cb=new RegExp("["+Vd+"]","g"),Gd="[^"+Vd+"]",Rb="[^"+Vd.replace("\\.","")+"]",Pb=/((?:WC+[\/:])*)/.source.replace("WC",Gd),Ib=/(WCOD+)?/.source.replace("WCOD",Rb),Lb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gd),Nb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gd),Db=new RegExp("^"+Pb+Ib+Lb+Nb+"$"),Ob=["material","materials","bones","map"],od=class{constructor(t,e,i){let s=i||Xe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Xe=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Cb,"")}static parseTrackName(t){let e=Db.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Ob.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Qt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Qt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Qt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Qt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Qt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Qt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xe.Composite=od;Xe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xe.prototype.GetterByBindingType=[Xe.prototype._getValue_direct,Xe.prototype._getValue_array,Xe.prototype._getValue_arrayElement,Xe.prototype._getValue_toArray];Xe.prototype.SetterByBindingTypeAndVersioning=[[Xe.prototype._setValue_direct,Xe.prototype._setValue_direct_setNeedsUpdate,Xe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_array,Xe.prototype._setValue_array_setNeedsUpdate,Xe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_arrayElement,Xe.prototype._setValue_arrayElement_setNeedsUpdate,Xe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_fromArray,Xe.prototype._setValue_fromArray_setNeedsUpdate,Xe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var GI=new Float32Array(1);var Pm=new ae,Mr=class{constructor(t,e,i=0,s=1/0){this.ray=new Ws(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new go,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Qt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Pm.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Pm),this}intersectObject(t,e=!0,i=[]){return ad(t,this,i,e),i.sort(Im),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)ad(t[s],this,i,e);return i.sort(Im),i}};function Im(n,t){return n.distance-t.distance}function ad(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)ad(r[o],t,e,!0)}}var bo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=pe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(pe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ld=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Da=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Hd(n,t,e,i){let s=Ub(i);switch(e){case Td:return n*t;case Tc:return n*t/s.components*s.byteLength;case Cc:return n*t/s.components*s.byteLength;case Qs:return n*t*2/s.components*s.byteLength;case Rc:return n*t*2/s.components*s.byteLength;case Cd:return n*t*3/s.components*s.byteLength;case Di:return n*t*4/s.components*s.byteLength;case Pc:return n*t*4/s.components*s.byteLength;case ka:case Fa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ba:case za:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Lc:case Dc:return Math.max(n,16)*Math.max(t,8)/4;case Ic:case Nc:return Math.max(n,8)*Math.max(t,8)/2;case Oc:case Uc:case Fc:case Bc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case kc:case Va:case zc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Vc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Gc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Hc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Wc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case $c:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Xc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case qc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Yc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Zc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Kc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Jc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case jc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Qc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case tu:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case eu:case nu:case iu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case su:case ru:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Ga:case ou:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Ub(n){switch(n){case ti:case Md:return{byteLength:1,components:1};case Ao:case wd:case Ni:return{byteLength:2,components:1};case Ac:case Ec:return{byteLength:2,components:4};case Li:case wc:case Si:return{byteLength:4,components:1};case Ad:case Ed:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Gg(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Fb(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Bb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,zb=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Vb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Gb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Wb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,$b=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Xb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,qb=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Yb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Zb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Kb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Jb=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,jb=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Qb=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,tS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,eS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,nS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,iS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,sS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,rS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,oS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,aS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,lS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,cS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,uS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,hS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,dS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,fS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,pS="gl_FragColor = linearToOutputTexel( gl_FragColor );",mS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,gS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,xS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,_S=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,yS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,vS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,bS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,SS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,MS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,wS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,AS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,ES=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,TS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,CS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,RS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,PS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,IS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,LS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,NS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,DS=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,OS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,US=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,kS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,FS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,BS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,zS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,VS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,GS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,HS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,WS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,$S=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,XS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,qS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,YS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ZS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,KS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,JS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,jS=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,QS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,tM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,eM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,nM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,iM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,sM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,rM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,oM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,aM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,lM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,cM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,uM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,hM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,dM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,fM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,pM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,mM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,gM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,xM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,_M=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,yM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,vM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,bM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,SM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,MM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,wM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,AM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,EM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,TM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,CM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,RM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,PM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,IM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,LM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,NM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,DM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,OM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,UM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,kM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,FM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,BM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,VM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,GM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,HM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,$M=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,XM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,qM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,YM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ZM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,JM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,QM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,tw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ew=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,iw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,rw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,ow=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,aw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,cw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,hw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,fw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,pw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,mw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,gw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,xw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ue={alphahash_fragment:Bb,alphahash_pars_fragment:zb,alphamap_fragment:Vb,alphamap_pars_fragment:Gb,alphatest_fragment:Hb,alphatest_pars_fragment:Wb,aomap_fragment:$b,aomap_pars_fragment:Xb,batching_pars_vertex:qb,batching_vertex:Yb,begin_vertex:Zb,beginnormal_vertex:Kb,bsdfs:Jb,iridescence_fragment:jb,bumpmap_pars_fragment:Qb,clipping_planes_fragment:tS,clipping_planes_pars_fragment:eS,clipping_planes_pars_vertex:nS,clipping_planes_vertex:iS,color_fragment:sS,color_pars_fragment:rS,color_pars_vertex:oS,color_vertex:aS,common:lS,defaultnormal_vertex:cS,displacementmap_pars_vertex:uS,displacementmap_vertex:hS,emissivemap_fragment:dS,emissivemap_pars_fragment:fS,colorspace_fragment:pS,colorspace_pars_fragment:mS,envmap_fragment:gS,envmap_common_pars_fragment:xS,envmap_pars_fragment:_S,envmap_pars_vertex:yS,envmap_physical_pars_fragment:PS,envmap_vertex:vS,fog_vertex:bS,fog_pars_vertex:SS,fog_fragment:MS,fog_pars_fragment:wS,gradientmap_pars_fragment:AS,lightmap_pars_fragment:ES,lights_lambert_fragment:TS,lights_lambert_pars_fragment:CS,lights_pars_begin:RS,lights_toon_fragment:IS,lights_toon_pars_fragment:LS,lights_phong_fragment:NS,lights_phong_pars_fragment:DS,lights_physical_fragment:OS,lights_physical_pars_fragment:US,lights_fragment_begin:kS,lights_fragment_maps:FS,lights_fragment_end:BS,lightprobes_pars_fragment:zS,logdepthbuf_fragment:VS,logdepthbuf_pars_fragment:GS,logdepthbuf_pars_vertex:HS,logdepthbuf_vertex:WS,map_fragment:$S,map_pars_fragment:XS,map_particle_fragment:qS,map_particle_pars_fragment:YS,metalnessmap_fragment:ZS,metalnessmap_pars_fragment:KS,morphinstance_vertex:JS,morphcolor_vertex:jS,morphnormal_vertex:QS,morphtarget_pars_vertex:tM,morphtarget_vertex:eM,normal_fragment_begin:nM,normal_fragment_maps:iM,normal_pars_fragment:sM,normal_pars_vertex:rM,normal_vertex:oM,normalmap_pars_fragment:aM,clearcoat_normal_fragment_begin:lM,clearcoat_normal_fragment_maps:cM,clearcoat_pars_fragment:uM,iridescence_pars_fragment:hM,opaque_fragment:dM,packing:fM,premultiplied_alpha_fragment:pM,project_vertex:mM,dithering_fragment:gM,dithering_pars_fragment:xM,roughnessmap_fragment:_M,roughnessmap_pars_fragment:yM,shadowmap_pars_fragment:vM,shadowmap_pars_vertex:bM,shadowmap_vertex:SM,shadowmask_pars_fragment:MM,skinbase_vertex:wM,skinning_pars_vertex:AM,skinning_vertex:EM,skinnormal_vertex:TM,specularmap_fragment:CM,specularmap_pars_fragment:RM,tonemapping_fragment:PM,tonemapping_pars_fragment:IM,transmission_fragment:LM,transmission_pars_fragment:NM,uv_pars_fragment:DM,uv_pars_vertex:OM,uv_vertex:UM,worldpos_vertex:kM,background_vert:FM,background_frag:BM,backgroundCube_vert:zM,backgroundCube_frag:VM,cube_vert:GM,cube_frag:HM,depth_vert:WM,depth_frag:$M,distance_vert:XM,distance_frag:qM,equirect_vert:YM,equirect_frag:ZM,linedashed_vert:KM,linedashed_frag:JM,meshbasic_vert:jM,meshbasic_frag:QM,meshlambert_vert:tw,meshlambert_frag:ew,meshmatcap_vert:nw,meshmatcap_frag:iw,meshnormal_vert:sw,meshnormal_frag:rw,meshphong_vert:ow,meshphong_frag:aw,meshphysical_vert:lw,meshphysical_frag:cw,meshtoon_vert:uw,meshtoon_frag:hw,points_vert:dw,points_frag:fw,shadow_vert:pw,shadow_frag:mw,sprite_vert:gw,sprite_frag:xw},Lt={common:{diffuse:{value:new $t(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new te}},envmap:{envMap:{value:null},envMapRotation:{value:new te},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new te}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new te}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new te},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new te},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new te},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new te}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new te}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new te}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new $t(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new $t(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0},uvTransform:{value:new te}},sprite:{diffuse:{value:new $t(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}}},ns={basic:{uniforms:Vn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:Vn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new $t(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:Vn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new $t(0)},specular:{value:new $t(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:Vn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new $t(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:Vn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new $t(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:Vn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:Vn([Lt.points,Lt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:Vn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:Vn([Lt.common,Lt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:Vn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:Vn([Lt.sprite,Lt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new te},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new te}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:Vn([Lt.common,Lt.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:Vn([Lt.lights,Lt.fog,{color:{value:new $t(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};ns.physical={uniforms:Vn([ns.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new te},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new te},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new te},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new te},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new te},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new te},sheen:{value:0},sheenColor:{value:new $t(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new te},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new te},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new te},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new te},attenuationDistance:{value:0},attenuationColor:{value:new $t(0)},specularColor:{value:new $t(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new te},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new te},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new te}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var lu={r:0,b:0,g:0},_w=new ae,Hg=new te;Hg.set(-1,0,0,0,1,0,0,0,1);function yw(n,t,e,i,s,r){let o=new $t(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let b=_.isScene===!0?_.background:null;if(b&&b.isTexture){let v=_.backgroundBlurriness>0;b=t.get(b,v)}return b}function p(_){let b=!1,v=f(_);v===null?g(o,a):v&&v.isColor&&(g(v,1),b=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,b){let v=f(b);v&&v.isCubeTexture?(c===void 0&&(c=new gn(new _o(1,1,1),new Qi({name:"BackgroundCubeMaterial",uniforms:Cr(ns.backgroundCube.uniforms),vertexShader:ns.backgroundCube.vertexShader,fragmentShader:ns.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,A,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(_w.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Hg),c.material.toneMapped=_e.getTransfer(v.colorSpace)!==Ce,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new gn(new Ta(2,2),new Qi({name:"BackgroundMaterial",uniforms:Cr(ns.background.uniforms),vertexShader:ns.background.vertexShader,fragmentShader:ns.background.fragmentShader,side:js,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=_e.getTransfer(v.colorSpace)!==Ce,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,b){_.getRGB(lu,zd(n)),e.buffers.color.setClear(lu.r,lu.g,lu.b,b,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,b=1){o.set(_),a=b,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:x,dispose:m}}function vw(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(C,D,k,N,B){let W=!1,H=h(C,N,k,D);r!==H&&(r=H,c(r.object)),W=f(C,N,k,B),W&&p(C,N,k,B),B!==null&&t.update(B,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,v(C,D,k,N),B!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function u(C){return n.deleteVertexArray(C)}function h(C,D,k,N){let B=N.wireframe===!0,W=i[D.id];W===void 0&&(W={},i[D.id]=W);let H=C.isInstancedMesh===!0?C.id:0,st=W[H];st===void 0&&(st={},W[H]=st);let Y=st[k.id];Y===void 0&&(Y={},st[k.id]=Y);let Q=Y[B];return Q===void 0&&(Q=d(l()),Y[B]=Q),Q}function d(C){let D=[],k=[],N=[];for(let B=0;B<e;B++)D[B]=0,k[B]=0,N[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:k,attributeDivisors:N,object:C,attributes:{},index:null}}function f(C,D,k,N){let B=r.attributes,W=D.attributes,H=0,st=k.getAttributes();for(let Y in st)if(st[Y].location>=0){let it=B[Y],ft=W[Y];if(ft===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(ft=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(ft=C.instanceColor)),it===void 0||it.attribute!==ft||ft&&it.data!==ft.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function p(C,D,k,N){let B={},W=D.attributes,H=0,st=k.getAttributes();for(let Y in st)if(st[Y].location>=0){let it=W[Y];it===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(it=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(it=C.instanceColor));let ft={};ft.attribute=it,it&&it.data&&(ft.data=it.data),B[Y]=ft,H++}r.attributes=B,r.attributesNum=H,r.index=N}function x(){let C=r.newAttributes;for(let D=0,k=C.length;D<k;D++)C[D]=0}function g(C){m(C,0)}function m(C,D){let k=r.newAttributes,N=r.enabledAttributes,B=r.attributeDivisors;k[C]=1,N[C]===0&&(n.enableVertexAttribArray(C),N[C]=1),B[C]!==D&&(n.vertexAttribDivisor(C,D),B[C]=D)}function _(){let C=r.newAttributes,D=r.enabledAttributes;for(let k=0,N=D.length;k<N;k++)D[k]!==C[k]&&(n.disableVertexAttribArray(k),D[k]=0)}function b(C,D,k,N,B,W,H){H===!0?n.vertexAttribIPointer(C,D,k,B,W):n.vertexAttribPointer(C,D,k,N,B,W)}function v(C,D,k,N){x();let B=N.attributes,W=k.getAttributes(),H=D.defaultAttributeValues;for(let st in W){let Y=W[st];if(Y.location>=0){let Q=B[st];if(Q===void 0&&(st==="instanceMatrix"&&C.instanceMatrix&&(Q=C.instanceMatrix),st==="instanceColor"&&C.instanceColor&&(Q=C.instanceColor)),Q!==void 0){let it=Q.normalized,ft=Q.itemSize,dt=t.get(Q);if(dt===void 0)continue;let tt=dt.buffer,ht=dt.type,gt=dt.bytesPerElement,St=ht===n.INT||ht===n.UNSIGNED_INT||Q.gpuType===wc;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Vt=0;Vt<Y.locationSize;Vt++)m(Y.location+Vt,Mt.meshPerAttribute);C.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Vt=0;Vt<Y.locationSize;Vt++)g(Y.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<Y.locationSize;Vt++)b(Y.location+Vt,ft/Y.locationSize,ht,it,Ht*gt,(se+ft/Y.locationSize*Vt)*gt,St)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<Y.locationSize;Mt++)m(Y.location+Mt,Q.meshPerAttribute);C.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<Y.locationSize;Mt++)g(Y.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Mt=0;Mt<Y.locationSize;Mt++)b(Y.location+Mt,ft/Y.locationSize,ht,it,ft*gt,ft/Y.locationSize*Mt*gt,St)}}else if(H!==void 0){let it=H[st];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(Y.location,it);break;case 3:n.vertexAttrib3fv(Y.location,it);break;case 4:n.vertexAttrib4fv(Y.location,it);break;default:n.vertexAttrib1fv(Y.location,it)}}}}_()}function E(){I();for(let C in i){let D=i[C];for(let k in D){let N=D[k];for(let B in N){let W=N[B];for(let H in W)u(W[H].object),delete W[H];delete N[B]}}delete i[C]}}function A(C){if(i[C.id]===void 0)return;let D=i[C.id];for(let k in D){let N=D[k];for(let B in N){let W=N[B];for(let H in W)u(W[H].object),delete W[H];delete N[B]}}delete i[C.id]}function y(C){for(let D in i){let k=i[D];for(let N in k){let B=k[N];if(B[C.id]===void 0)continue;let W=B[C.id];for(let H in W)u(W[H].object),delete W[H];delete B[C.id]}}}function M(C){for(let D in i){let k=i[D],N=C.isInstancedMesh===!0?C.id:0,B=k[N];if(B!==void 0){for(let W in B){let H=B[W];for(let st in H)u(H[st].object),delete H[st];delete B[W]}delete k[N],Object.keys(k).length===0&&delete i[D]}}}function I(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:L,dispose:E,releaseStatesOfGeometry:A,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:g,disableUnusedAttributes:_}}function bw(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Sw(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Di&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Ni&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==ti&&y!==Si&&!M&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(qt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:b,maxFragmentUniforms:v,maxSamples:E,samples:A}}function Mw(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ci,a=new te,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,g=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let _=r?0:i,b=_*4,v=m.clippingState||null;l.value=v,v=u(p,d,b,f);for(let E=0;E!==b;++E)v[E]=e[E];m.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let b=0,v=f;b!==x;++b,v+=4)o.copy(h[b]).applyMatrix4(_,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var Xa=class extends hi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new wa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new _o(5,5,5),r=new Qi({name:"CubemapFromEquirect",uniforms:Cr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Kn,blending:wr});r.uniforms.tEquirect.value=e;let o=new gn(s,r),a=e.minFilter;return e.minFilter===ws&&(e.minFilter=Zn),new vo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},bg=256,ww=3,Aw=20,Wg=256,$g=16,Ew=3,Tw=new V,Cw=new $t,uu=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new vo(1,10,null),this._boxMesh=new gn(new _o(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Tw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(Cw));let g=new vo(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=wg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Mg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(bg,kd(t))}_fromTexture(t,e){t.mapping===Er||t.mapping===wo?this._setSize(t.image.length===0?bg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Sg(t,!1,!1),i=Math.log2(t)-ww;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Sg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Er||t.mapping===wo?(this._cubemapMaterial===null&&(this._cubemapMaterial=wg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Mg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Rw(),this._integrationMaterial=Pw());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/$g);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Ew)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Wg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Iw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Sg(n,t,e){return new Xa(n,{minFilter:ws,generateMipmaps:t,type:Ni,colorSpace:ma,depthBuffer:e})}function qa(n,t,e){return new Qi({name:n,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:Kn,blending:wr,depthTest:!1,depthWrite:!1})}function Rw(){return qa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Wg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Pw(){return qa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:$g}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Iw(){return qa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Aw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Mg(){return qa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function wg(){return qa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Lw(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===bc||f===Sc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Xa(p.height);return x.fromEquirectangularTexture(n,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===bc||f===Sc,x=f===Er||f===wo;if(p||x){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new uu(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new uu(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===bc?d.mapping=Er:f===Sc&&(d.mapping=wo),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function Nw(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ha("WebGLRenderer: "+i+" extension not supported."),s}}}function Dw(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function u(p){let x=p.attributes;for(let g in x)t.update(x[g],n.ARRAY_BUFFER)}function h(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=x!==null?x.array.length:g.array.length/3-1,b=g.count>=65535?ba:va,v=new b(Math.ceil(_/3)*6,1),E=v.array;if(x!==null){let y=x.array;m=x.version;for(let M=0,I=0;M<_;M+=3){let L=y[M+0],C=y[M+1],D=y[M+2];E[I++]=L,E[I++]=C,E[I++]=C,E[I++]=D,E[I++]=D,E[I++]=L}}else{m=g.version;for(let y=0,M=0;y<_;y+=3){let I=y+0,L=y+1,C=y+2;E[M++]=I,E[M++]=L,E[M++]=L,E[M++]=C,E[M++]=C,E[M++]=I}}v.version=m;let A=r.get(p);A&&t.remove(A),r.set(p,v)}function d(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function Ow(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function Uw(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Qt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function kw(n,t,e){let i=new WeakMap,s=new Fe;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let I=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],b=0;f===!0&&(b=1),p===!0&&(b=2),x===!0&&(b=3);let v=a.attributes.position.count*b,E=1;v>t.maxTextureSize&&(E=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*E*4*h),y=new _a(A,v,E,h);y.type=Si,y.needsUpdate=!0;let M=b*4;for(let L=0;L<h;L++){let C=g[L],D=m[L],k=_[L],N=v*E*4*L;for(let B=0;B<C.count;B++){let W=B*M;f===!0&&(s.fromBufferAttribute(C,B),A[N+W+0]=s.x,A[N+W+1]=s.y,A[N+W+2]=s.z,A[N+W+3]=0),p===!0&&(s.fromBufferAttribute(D,B),A[N+W+4]=s.x,A[N+W+5]=s.y,A[N+W+6]=s.z,A[N+W+7]=0),x===!0&&(s.fromBufferAttribute(k,B),A[N+W+8]=s.x,A[N+W+9]=s.y,A[N+W+10]=s.z,A[N+W+11]=k.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Yt(v,E)},i.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function Fw(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var Bw={[md]:"LINEAR_TONE_MAPPING",[gd]:"REINHARD_TONE_MAPPING",[xd]:"CINEON_TONE_MAPPING",[_d]:"ACES_FILMIC_TONE_MAPPING",[vd]:"AGX_TONE_MAPPING",[bd]:"NEUTRAL_TONE_MAPPING",[yd]:"CUSTOM_TONE_MAPPING"};function zw(n,t,e,i,s,r){let o=new hi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new vn;u.setAttribute("position",new sn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new sn([0,2,0,0,2,0],2));let h=new rc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new gn(u,h),f=new La(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,_=null,b=[],v=!1;this.setSize=function(E,A){o.setSize(E,A),a!==null&&a.setSize(E,A),l!==null&&l.setSize(E,A);for(let y=0;y<b.length;y++){let M=b[y];M.setSize&&M.setSize(E,A)}},this.setEffects=function(E){b=E,v=b.length>0&&b[0].isRenderPass===!0;let A=o.width,y=o.height;b.length>0&&a===null&&(a=new hi(A,y,{type:Ni,depthBuffer:!1,stencilBuffer:!1}),l=new hi(A,y,{type:Ni,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&b.some(I=>I.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ss(A,y),r===!0&&(c.format=As,c.type=Tr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let I=0;I<b.length;I++){let L=b[I];L.setSize&&L.setSize(A,y),M&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(E,A){if(g||E.toneMapping===ts&&b.length===0)return!1;if(_=A,A!==null){let y=A.width,M=A.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return v===!1&&E.setRenderTarget(o),m=E.toneMapping,E.toneMapping=ts,!0},this.hasRenderPass=function(){return v},this.end=function(E,A){E.toneMapping=m,g=!0;let y=o,M=a;for(let I=0;I<b.length;I++){let L=b[I];L.enabled!==!1&&(L.render(E,M,y,A),L.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(p!==E.outputColorSpace||x!==E.toneMapping){p=E.outputColorSpace,x=E.toneMapping,h.defines={},_e.getTransfer(p)===Ce&&(h.defines.SRGB_TRANSFER="");let I=Bw[x];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,E.setRenderTarget(_),E.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Xg=new Qn,qg=new Ss(1,1),Yg=new Aa(1),Zg=new _a,Kg=new tc,Jg=new wa,Ag=[],Eg=[],Tg=new Float32Array(16),Cg=new Float32Array(9),Rg=new Float32Array(4);function Co(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Ag[s];if(r===void 0&&(r=new Float32Array(s),Ag[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function bn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Sn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function du(n,t){let e=Eg[t];e===void 0&&(e=new Int32Array(t),Eg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Vw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Gw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2fv(this.addr,t),Sn(e,t)}}function Hw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(bn(e,t))return;n.uniform3fv(this.addr,t),Sn(e,t)}}function Ww(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4fv(this.addr,t),Sn(e,t)}}function $w(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,i))return;Rg.set(i),n.uniformMatrix2fv(this.addr,!1,Rg),Sn(e,i)}}function Xw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,i))return;Cg.set(i),n.uniformMatrix3fv(this.addr,!1,Cg),Sn(e,i)}}function qw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(bn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,i))return;Tg.set(i),n.uniformMatrix4fv(this.addr,!1,Tg),Sn(e,i)}}function Yw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Zw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2iv(this.addr,t),Sn(e,t)}}function Kw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;n.uniform3iv(this.addr,t),Sn(e,t)}}function Jw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4iv(this.addr,t),Sn(e,t)}}function jw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Qw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;n.uniform2uiv(this.addr,t),Sn(e,t)}}function t1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;n.uniform3uiv(this.addr,t),Sn(e,t)}}function e1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;n.uniform4uiv(this.addr,t),Sn(e,t)}}function fu(n){return n.version===0&&(n.compareFunction=Nd,n.needsUpdate=!0),n}function n1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=fu(qg):r=Xg,e.setTexture2D(t||r,s)}function i1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Kg,s)}function s1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=fu(Yg):r=Jg,e.setTextureCube(t||r,s)}function r1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Zg,s)}function o1(n){switch(n){case 5126:return Vw;case 35664:return Gw;case 35665:return Hw;case 35666:return Ww;case 35674:return $w;case 35675:return Xw;case 35676:return qw;case 5124:case 35670:return Yw;case 35667:case 35671:return Zw;case 35668:case 35672:return Kw;case 35669:case 35673:return Jw;case 5125:return jw;case 36294:return Qw;case 36295:return t1;case 36296:return e1;case 35678:case 36198:case 36298:case 36306:case 35682:return n1;case 35679:case 36299:case 36307:return i1;case 35680:case 36300:case 36308:case 36293:return s1;case 36289:case 36303:case 36311:case 36292:return r1}}function a1(n,t){n.uniform1fv(this.addr,t)}function l1(n,t){let e=Co(t,this.size,2);n.uniform2fv(this.addr,e)}function c1(n,t){let e=Co(t,this.size,3);n.uniform3fv(this.addr,e)}function u1(n,t){let e=Co(t,this.size,4);n.uniform4fv(this.addr,e)}function h1(n,t){let e=Co(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function d1(n,t){let e=Co(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function f1(n,t){let e=Co(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function p1(n,t){n.uniform1iv(this.addr,t)}function m1(n,t){n.uniform2iv(this.addr,t)}function g1(n,t){n.uniform3iv(this.addr,t)}function x1(n,t){n.uniform4iv(this.addr,t)}function _1(n,t){n.uniform1uiv(this.addr,t)}function y1(n,t){n.uniform2uiv(this.addr,t)}function v1(n,t){n.uniform3uiv(this.addr,t)}function b1(n,t){n.uniform4uiv(this.addr,t)}function S1(n,t,e){let i=this.cache,s=t.length,r=du(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=fu(qg):o=Xg;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function M1(n,t,e){let i=this.cache,s=t.length,r=du(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Kg,r[o])}function w1(n,t,e){let i=this.cache,s=t.length,r=du(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=fu(Yg):o=Jg;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function A1(n,t,e){let i=this.cache,s=t.length,r=du(e,s);bn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Zg,r[o])}function E1(n){switch(n){case 5126:return a1;case 35664:return l1;case 35665:return c1;case 35666:return u1;case 35674:return h1;case 35675:return d1;case 35676:return f1;case 5124:case 35670:return p1;case 35667:case 35671:return m1;case 35668:case 35672:return g1;case 35669:case 35673:return x1;case 5125:return _1;case 36294:return y1;case 36295:return v1;case 36296:return b1;case 35678:case 36198:case 36298:case 36306:case 35682:return S1;case 35679:case 36299:case 36307:return M1;case 35680:case 36300:case 36308:case 36293:return w1;case 36289:case 36303:case 36311:case 36292:return A1}}var Xd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=o1(e.type)}},qd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=E1(e.type)}},Yd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Wd=/(\w+)(\])?(\[|\.)?/g;function Pg(n,t){n.seq.push(t),n.map[t.id]=t}function T1(n,t,e){let i=n.name,s=i.length;for(Wd.lastIndex=0;;){let r=Wd.exec(i),o=Wd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Pg(e,c===void 0?new Xd(a,n,t):new qd(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Yd(a),Pg(e,h)),e=h}}}var To=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);T1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Ig(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var C1=37297,R1=0;function P1(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Lg=new te;function I1(n){_e._getMatrix(Lg,_e.workingColorSpace,n);let t=`mat3( ${Lg.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(n)){case ga:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Ng(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+P1(n.getShaderSource(t),a)}else return r}function L1(n,t){let e=I1(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var N1={[md]:"Linear",[gd]:"Reinhard",[xd]:"Cineon",[_d]:"ACESFilmic",[vd]:"AgX",[bd]:"Neutral",[yd]:"Custom"};function D1(n,t){let e=N1[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var cu=new V;function O1(){_e.getLuminanceCoefficients(cu);let n=cu.x.toFixed(4),t=cu.y.toFixed(4),e=cu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function U1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function k1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function F1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function $a(n){return n!==""}function Dg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Og(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var B1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Zd(n){return n.replace(B1,z1)}function z1(n,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Zd(e)}var V1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ug(n){return n.replace(V1,G1)}function G1(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function kg(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var H1={[Oa]:"SHADOWMAP_TYPE_PCF",[So]:"SHADOWMAP_TYPE_VSM"};function W1(n){return H1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var $1={[wo]:"ENVMAP_MODE_REFRACTION"};function X1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":$1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var q1={[vc]:"ENVMAP_BLENDING_MULTIPLY",[Qm]:"ENVMAP_BLENDING_MIX",[tg]:"ENVMAP_BLENDING_ADD"};function Y1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":q1[n.combine]||"ENVMAP_BLENDING_NONE"}function Z1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=W1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=X1(e),h=Y1(e),d=U1(e),f=k1(r),p=s.createProgram(),x,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter($a).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter($a).join(`
`),g.length>0&&(g+=`
`)):(x=[kg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),g=[kg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ts?"#define TONE_MAPPING":"",e.toneMapping!==ts?ue.tonemapping_pars_fragment:"",e.toneMapping!==ts?D1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,L1("linearToOutputTexel",e.outputColorSpace),O1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter($a).join(`
`)),o=Zd(o),o=Dg(o,e),o=Og(o,e),a=Zd(a),a=Dg(a,e),a=Og(a,e),o=Ug(o),a=Ug(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===Dd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Dd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+x+o,b=m+g+a,v=Ig(s,s.VERTEX_SHADER,_),E=Ig(s,s.FRAGMENT_SHADER,b);s.attachShader(p,v),s.attachShader(p,E),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(L){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(p)||"",D=s.getShaderInfoLog(v)||"",k=s.getShaderInfoLog(E)||"",N=C.trim(),B=D.trim(),W=k.trim(),H=!0,st=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,E);else{let Y=Ng(s,v,"vertex"),Q=Ng(s,E,"fragment");Qt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+Y+`
`+Q)}else N!==""?qt("WebGLProgram: Program Info Log:",N):(B===""||W==="")&&(st=!1);st&&(L.diagnostics={runnable:H,programLog:N,vertexShader:{log:B,prefix:x},fragmentShader:{log:W,prefix:g}})}s.deleteShader(v),s.deleteShader(E),y=new To(s,p),M=F1(s,p)}let y;this.getUniforms=function(){return y===void 0&&A(this),y};let M;this.getAttributes=function(){return M===void 0&&A(this),M};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,C1)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=R1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=E,this}var K1=0,Kd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Jd(t),e.set(t,i)),i}},Jd=class{constructor(t){this.id=K1++,this.code=t,this.usedTimes=0}};function J1(n){return n===Qs||n===Va||n===Ga}function j1(n,t,e,i,s,r){let o=new go,a=new Kd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,M,I,L,C,D){let k=L.fog,N=C.geometry,B=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||B,W),st=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&qt("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,it=Q!==void 0?Q.length:0,ft=0;N.morphAttributes.position!==void 0&&(ft=1),N.morphAttributes.normal!==void 0&&(ft=2),N.morphAttributes.color!==void 0&&(ft=3);let dt,tt,ht,gt;if(st){let Ct=ns[st];dt=Ct.vertexShader,tt=Ct.fragmentShader}else{dt=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),oe=a.getFragmentShaderStage(y);a.update(y,Ct,oe),ht=Ct.id,gt=oe.id}let St=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Ht=C.isInstancedMesh===!0,se=C.isBatchedMesh===!0,Vt=!!y.map,he=!!y.matcap,le=!!H,ne=le&&H.isPMREMTexture===!0,Ze=!!y.aoMap,Ve=!!y.lightMap,cn=!!y.bumpMap&&y.wireframe===!1,Ne=!!y.normalMap,En=!!y.displacementMap,ve=!!y.emissiveMap,_n=!!y.metalnessMap,je=!!y.roughnessMap,un=y.anisotropy>0,G=y.clearcoat>0,Rt=y.diffuseRoughness>0,Zt=y.dispersion>0,re=y.retroreflectivity>0,wt=y.iridescence>0,ke=y.sheen>0,zt=y.transmission>0,Xt=un&&!!y.anisotropyMap,O=G&&!!y.clearcoatMap,T=G&&!!y.clearcoatNormalMap,q=G&&!!y.clearcoatRoughnessMap,ut=Rt&&!!y.diffuseRoughnessMap,at=wt&&!!y.iridescenceMap,_t=wt&&!!y.iridescenceThicknessMap,yt=ke&&!!y.sheenColorMap,et=ke&&!!y.sheenRoughnessMap,rt=!!y.specularMap,mt=!!y.specularColorMap,z=!!y.specularIntensityMap,ot=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,At=!!y.gradientMap,xt=!!y.alphaMap,bt=y.alphaTest>0,Gt=!!y.alphaHash,Jt=!!y.extensions,ct=ts;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ct=n.toneMapping);let kt=ne?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,jt={shaderID:st,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:tt,defines:y.defines,customVertexShaderID:ht,customFragmentShaderID:gt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:se,batchingColor:se&&C._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&C.instanceColor!==null,instancingMorph:Ht&&C.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:he,envMap:le,envMapMode:le&&H.mapping,envMapPMREM:ne,envMapMaxLod:ne?kt.length-1:null,envMapSize:ne?kt[0].width:null,aoMap:Ze,lightMap:Ve,bumpMap:cn,normalMap:Ne,displacementMap:En,emissiveMap:ve,normalMapObjectSpace:Ne&&y.normalMapType===ig,normalMapTangentSpace:Ne&&y.normalMapType===au,packedNormalMap:Ne&&y.normalMapType===au&&J1(y.normalMap.format),metalnessMap:_n,roughnessMap:je,anisotropy:un,anisotropyMap:Xt,clearcoat:G,clearcoatMap:O,clearcoatNormalMap:T,clearcoatRoughnessMap:q,diffuseRoughness:Rt,diffuseRoughnessMap:ut,dispersion:Zt,retroreflection:re,iridescence:wt,iridescenceMap:at,iridescenceThicknessMap:_t,sheen:ke,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:rt,specularColorMap:mt,specularIntensityMap:z,transmission:zt,transmissionMap:ot,thicknessMap:nt,gradientMap:At,opaque:y.transparent===!1&&y.blending===Mo&&y.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Gt,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:Ze&&f(y.aoMap.channel),lightMapUv:Ve&&f(y.lightMap.channel),bumpMapUv:cn&&f(y.bumpMap.channel),normalMapUv:Ne&&f(y.normalMap.channel),displacementMapUv:En&&f(y.displacementMap.channel),emissiveMapUv:ve&&f(y.emissiveMap.channel),metalnessMapUv:_n&&f(y.metalnessMap.channel),roughnessMapUv:je&&f(y.roughnessMap.channel),anisotropyMapUv:Xt&&f(y.anisotropyMap.channel),clearcoatMapUv:O&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(y.sheenRoughnessMap.channel),specularMapUv:rt&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:z&&f(y.specularIntensityMap.channel),transmissionMapUv:ot&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:xt&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ne||un),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!N.attributes.uv&&(Vt||xt),fog:!!k,useFog:y.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Ne===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Mt,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:ft,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:D.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&_e.getTransfer(y.map.colorSpace)===Ce,decodeVideoTextureEmissive:ve&&y.emissiveMap.isVideoTexture===!0&&_e.getTransfer(y.emissiveMap.colorSpace)===Ce,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===zn,flipSided:y.side===Kn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Jt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&y.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return jt.vertexUv1s=l.has(1),jt.vertexUv2s=l.has(2),jt.vertexUv3s=l.has(3),l.clear(),jt}function x(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)M.push(I),M.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(g(M,y),m(M,y),M.push(n.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function g(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function m(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let M=d[y.type],I;if(M){let L=ns[M];I=_g.clone(L.uniforms)}else I=y.uniforms;return I}function b(y,M){let I=u.get(M);return I!==void 0?++I.usedTimes:(I=new Z1(n,M,y,s),c.push(I),u.set(M,I)),I}function v(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function E(y){a.remove(y)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:b,releaseProgram:v,releaseShaderCache:E,programs:c,dispose:A}}function Q1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function tA(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Fg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Bg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,g,m){let _=n[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},n[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=g,_.group=m),t++,_}function l(d,f,p,x,g,m,_){_.reversedDepth===!0&&(g=-g);let b=a(d,f,p,x,g,m);p.transmission>0?i.push(b):p.transparent===!0?s.push(b):e.push(b)}function c(d,f,p,x,g,m){let _=a(d,f,p,x,g,m);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function u(d,f){e.length>1&&e.sort(d||tA),i.length>1&&i.sort(f||Fg),s.length>1&&s.sort(f||Fg)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function eA(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Bg,n.set(i,[o])):s>=r.length?(o=new Bg,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function nA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new V,color:new $t};break;case"SpotLight":e={position:new V,direction:new V,color:new $t,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new V,color:new $t,distance:0,decay:0};break;case"HemisphereLight":e={direction:new V,skyColor:new $t,groundColor:new $t};break;case"RectAreaLight":e={color:new $t,position:new V,halfWidth:new V,halfHeight:new V};break}return n[t.id]=e,e}}}function iA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var sA=0;function rA(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function oA(n){let t=new nA,e=iA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new V);let s=new V,r=new ae,o=new ae;function a(c){let u=0,h=0,d=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let f=0,p=0,x=0,g=0,m=0,_=0,b=0,v=0,E=0,A=0,y=0,M=0,I=0,L=0;c.sort(rA);for(let D=0,k=c.length;D<k;D++){let N=c[D],B=N.color,W=N.intensity,H=N.distance,st=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Qs?st=N.shadow.map.texture:st=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=B.r*W,h+=B.g*W,d+=B.b*W;else if(N.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(N.sh.coefficients[Y],W);L++}else if(N.isSunLight){let Y=t.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=it,i.sunShadowMap[p]=st;let ft=Q.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[x+dt]=Q.getMatrix(dt),i.sunShadowCascade[x+dt]=Q._cascadeData[dt];x+=ft,p++}i.sun[f]=Y,f++}else if(N.isDirectionalLight){let Y=t.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[g]=it,i.directionalShadowMap[g]=st,i.directionalShadowMatrix[g]=N.shadow.matrix,E++}i.directional[g]=Y,g++}else if(N.isSpotLight){let Y=t.get(N);Y.position.setFromMatrixPosition(N.matrixWorld),Y.color.copy(B).multiplyScalar(W),Y.distance=H,Y.coneCos=Math.cos(N.angle),Y.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Y.decay=N.decay,i.spot[_]=Y;let Q=N.shadow;if(N.map&&(i.spotLightMap[M]=N.map,M++,Q.updateMatrices(N),N.castShadow&&I++),i.spotLightMatrix[_]=Q.matrix,N.castShadow){let it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[_]=it,i.spotShadowMap[_]=st,y++}_++}else if(N.isRectAreaLight){let Y=t.get(N);Y.color.copy(B).multiplyScalar(W),Y.halfWidth.set(N.width*.5,0,0),Y.halfHeight.set(0,N.height*.5,0),i.rectArea[b]=Y,b++}else if(N.isPointLight){let Y=t.get(N);if(Y.color.copy(N.color).multiplyScalar(N.intensity),Y.distance=N.distance,Y.decay=N.decay,N.castShadow){let Q=N.shadow,it=e.get(N);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[m]=it,i.pointShadowMap[m]=st,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=Y,m++}else if(N.isHemisphereLight){let Y=t.get(N);Y.skyColor.copy(N.color).multiplyScalar(W),Y.groundColor.copy(N.groundColor).multiplyScalar(W),i.hemi[v]=Y,v++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let C=i.hash;(C.sunLength!==f||C.directionalLength!==g||C.pointLength!==m||C.spotLength!==_||C.rectAreaLength!==b||C.hemiLength!==v||C.numSunShadows!==p||C.numDirectionalShadows!==E||C.numPointShadows!==A||C.numSpotShadows!==y||C.numSpotMaps!==M||C.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=g,i.spot.length=_,i.rectArea.length=b,i.point.length=m,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+M-I,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=L,C.sunLength=f,C.directionalLength=g,C.pointLength=m,C.spotLength=_,C.rectAreaLength=b,C.hemiLength=v,C.numSunShadows=p,C.numDirectionalShadows=E,C.numPointShadows=A,C.numSpotShadows=y,C.numSpotMaps=M,C.numLightProbes=L,i.version=sA++)}function l(c,u){let h=0,d=0,f=0,p=0,x=0,g=0,m=u.matrixWorldInverse;for(let _=0,b=c.length;_<b;_++){let v=c[_];if(v.isSunLight){let E=i.sun[h];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(m),h++}else if(v.isDirectionalLight){let E=i.directional[d];E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),d++}else if(v.isSpotLight){let E=i.spot[p];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),p++}else if(v.isRectAreaLight){let E=i.rectArea[x];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),E.halfWidth.set(v.width*.5,0,0),E.halfHeight.set(0,v.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let E=i.point[f];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let E=i.hemi[g];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function zg(n){let t=new oA(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function aA(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new zg(n),t.set(s,[a])):r>=o.length?(a=new zg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var lA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,cA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,uA=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],hA=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Vg=new ae,Wa=new V,$d=new V;function dA(n,t,e){let i=new $s,s=new Yt,r=new Yt,o=new Fe,a=new oc,l=new ac,c={},u=e.maxTextureSize,h={[js]:Kn,[Kn]:js,[zn]:zn},d=new Qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:lA,fragmentShader:cA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new vn;p.setAttribute("position",new an(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new gn(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Oa;let m=this.type;this.render=function(A,y,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Dm&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Oa);let I=n.getRenderTarget(),L=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),D=n.state;D.setBlending(wr),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let k=m!==this.type;k&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(B=>B.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,B=A.length;N<B;N++){let W=A[N],H=W.shadow;if(H===void 0){qt("WebGLShadowMap:",W,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let st=H.getFrameExtents();s.multiply(st),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/st.x),s.x=r.x*st.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/st.y),s.y=r.y*st.y,H.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Y,H.map===null||k===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===So){if(W.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new hi(s.x,s.y,{format:Qs,type:Ni,minFilter:Zn,magFilter:Zn,generateMipmaps:!1}),H.map.texture.name=W.name+".shadowMap",H.map.depthTexture=new Ss(s.x,s.y,Si),H.map.depthTexture.name=W.name+".shadowMapDepth",H.map.depthTexture.format=xs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Nn,H.map.depthTexture.magFilter=Nn}else W.isPointLight?(H.map=new Xa(s.x),H.map.depthTexture=new Aa(s.x,Li)):(H.map=new hi(s.x,s.y),H.map.depthTexture=new Ss(s.x,s.y,Li)),H.map.depthTexture.name=W.name+".shadowMap",H.map.depthTexture.format=xs,this.type===Oa?(H.map.depthTexture.compareFunction=Y?Ld:Id,H.map.depthTexture.minFilter=Zn,H.map.depthTexture.magFilter=Zn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Nn,H.map.depthTexture.magFilter=Nn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();W.isPointLight!==!0&&H.updateMatrices(W,M);let it=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:M.layers;for(let ft=0;ft<Q;ft++){let dt=H.getCamera(ft);if(W.isPointLight){let tt=H.camera,ht=H.matrix,gt=W.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),Wa.setFromMatrixPosition(W.matrixWorld),tt.position.copy(Wa),$d.copy(tt.position),$d.add(uA[ft]),tt.up.copy(hA[ft]),tt.lookAt($d),tt.updateMatrixWorld(),ht.makeTranslation(-Wa.x,-Wa.y,-Wa.z),Vg.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Vg,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(H.map),n.clear());let tt=H.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),D.viewport(o)}i=H.getFrustum(ft),v(y,M,dt,W,it,this.type)}H.isPointLightShadow!==!0&&this.type===So&&_(H,M),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(I,L,C)};function _(A,y){let M=t.update(x);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new hi(s.x,s.y,{format:Qs,type:Ni}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(y,null,M,d,x,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(y,null,M,f,x,null)}function b(A,y,M,I){let L=null,C=M.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(C!==void 0)L=C;else if(L=M.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let D=L.uuid,k=y.uuid,N=c[D];N===void 0&&(N={},c[D]=N);let B=N[k];B===void 0&&(B=L.clone(),N[k]=B,y.addEventListener("dispose",E)),L=B}if(L.visible=y.visible,L.wireframe=y.wireframe,I===So?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,M.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let D=n.properties.get(L);D.light=M}return L}function v(A,y,M,I,L,C){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&C===So)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,A.matrixWorld);let N=t.update(A),B=A.material;if(Array.isArray(B)){let W=N.groups;for(let H=0,st=W.length;H<st;H++){let Y=W[H],Q=B[Y.materialIndex];if(Q&&Q.visible){let it=b(A,Q,I,C);A.onBeforeShadow(n,A,y,M,N,it,Y),n.renderBufferDirect(M,null,N,it,A,Y),A.onAfterShadow(n,A,y,M,N,it,Y)}}}else if(B.visible){let W=b(A,B,I,C);A.onBeforeShadow(n,A,y,M,N,W,null),n.renderBufferDirect(M,null,N,W,A,null),A.onAfterShadow(n,A,y,M,N,W,null)}}let k=A.children;for(let N=0,B=k.length;N<B;N++)v(k[N],y,M,I,L,C)}function E(A){A.target.removeEventListener("dispose",E);for(let M in c){let I=c[M],L=A.target.uuid;L in I&&(I[L].dispose(),delete I[L])}}}function fA(n,t){function e(){let z=!1,ot=new Fe,nt=null,At=new Fe(0,0,0,0);return{setMask:function(xt){nt!==xt&&!z&&(n.colorMask(xt,xt,xt,xt),nt=xt)},setLocked:function(xt){z=xt},setClear:function(xt,bt,Gt,Jt,ct){ct===!0&&(xt*=Jt,bt*=Jt,Gt*=Jt),ot.set(xt,bt,Gt,Jt),At.equals(ot)===!1&&(n.clearColor(xt,bt,Gt,Jt),At.copy(ot))},reset:function(){z=!1,nt=null,At.set(-1,0,0,0)}}}function i(){let z=!1,ot=!1,nt=null,At=null,xt=null;return{setReversed:function(bt){if(ot!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),ot=bt;let Jt=xt;xt=null,this.setClear(Jt)}},getReversed:function(){return ot},setTest:function(bt){bt?Mt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!z&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(ot&&(bt=pg[bt]),At!==bt){switch(bt){case Gl:n.depthFunc(n.NEVER);break;case Hl:n.depthFunc(n.ALWAYS);break;case Wl:n.depthFunc(n.LESS);break;case uo:n.depthFunc(n.LEQUAL);break;case $l:n.depthFunc(n.EQUAL);break;case Xl:n.depthFunc(n.GEQUAL);break;case ql:n.depthFunc(n.GREATER);break;case Yl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=bt}},setLocked:function(bt){z=bt},setClear:function(bt){xt!==bt&&(xt=bt,ot&&(bt=1-bt),n.clearDepth(bt))},reset:function(){z=!1,nt=null,At=null,xt=null,ot=!1}}}function s(){let z=!1,ot=null,nt=null,At=null,xt=null,bt=null,Gt=null,Jt=null,ct=null;return{setTest:function(kt){z||(kt?Mt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(kt){ot!==kt&&!z&&(n.stencilMask(kt),ot=kt)},setFunc:function(kt,jt,Ct){(nt!==kt||At!==jt||xt!==Ct)&&(n.stencilFunc(kt,jt,Ct),nt=kt,At=jt,xt=Ct)},setOp:function(kt,jt,Ct){(bt!==kt||Gt!==jt||Jt!==Ct)&&(n.stencilOp(kt,jt,Ct),bt=kt,Gt=jt,Jt=Ct)},setLocked:function(kt){z=kt},setClear:function(kt){ct!==kt&&(n.clearStencil(kt),ct=kt)},reset:function(){z=!1,ot=null,nt=null,At=null,xt=null,bt=null,Gt=null,Jt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,g=!1,m=null,_=null,b=null,v=null,E=null,A=null,y=null,M=new $t(0,0,0),I=0,L=!1,C=null,D=null,k=null,N=null,B=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,st=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(st=parseFloat(/^WebGL (\d)/.exec(Y)[1]),H=st>=1):Y.indexOf("OpenGL ES")!==-1&&(st=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),H=st>=2);let Q=null,it={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),tt=new Fe().fromArray(ft),ht=new Fe().fromArray(dt);function gt(z,ot,nt,At){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(z,bt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(ot+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let St={};St[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(uo),cn(!1),Ne(cd),Mt(n.CULL_FACE),Ze(wr);function Mt(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function Ht(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function se(z,ot){return d[z]!==ot?(n.bindFramebuffer(z,ot),d[z]=ot,z===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=ot),z===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function Vt(z,ot){let nt=p,At=!1;if(z){nt=f.get(ot),nt===void 0&&(nt=[],f.set(ot,nt));let xt=z.textures;if(nt.length!==xt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Gt=xt.length;bt<Gt;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=xt.length,At=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,At=!0);At&&n.drawBuffers(nt)}function he(z){return x!==z?(n.useProgram(z),x=z,!0):!1}let le={[Ar]:n.FUNC_ADD,[Um]:n.FUNC_SUBTRACT,[km]:n.FUNC_REVERSE_SUBTRACT};le[Fm]=n.MIN,le[Bm]=n.MAX;let ne={[zm]:n.ZERO,[Vm]:n.ONE,[Gm]:n.SRC_COLOR,[fd]:n.SRC_ALPHA,[Ym]:n.SRC_ALPHA_SATURATE,[Xm]:n.DST_COLOR,[Wm]:n.DST_ALPHA,[Hm]:n.ONE_MINUS_SRC_COLOR,[pd]:n.ONE_MINUS_SRC_ALPHA,[qm]:n.ONE_MINUS_DST_COLOR,[$m]:n.ONE_MINUS_DST_ALPHA,[Zm]:n.CONSTANT_COLOR,[Km]:n.ONE_MINUS_CONSTANT_COLOR,[Jm]:n.CONSTANT_ALPHA,[jm]:n.ONE_MINUS_CONSTANT_ALPHA};function Ze(z,ot,nt,At,xt,bt,Gt,Jt,ct,kt){if(z===wr){g===!0&&(Ht(n.BLEND),g=!1);return}if(g===!1&&(Mt(n.BLEND),g=!0),z!==Om){if(z!==m||kt!==L){if((_!==Ar||E!==Ar)&&(n.blendEquation(n.FUNC_ADD),_=Ar,E=Ar),kt)switch(z){case Mo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ud:n.blendFunc(n.ONE,n.ONE);break;case hd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case dd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qt("WebGLState: Invalid blending: ",z);break}else switch(z){case Mo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ud:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hd:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case dd:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",z);break}b=null,v=null,A=null,y=null,M.set(0,0,0),I=0,m=z,L=kt}return}xt=xt||ot,bt=bt||nt,Gt=Gt||At,(ot!==_||xt!==E)&&(n.blendEquationSeparate(le[ot],le[xt]),_=ot,E=xt),(nt!==b||At!==v||bt!==A||Gt!==y)&&(n.blendFuncSeparate(ne[nt],ne[At],ne[bt],ne[Gt]),b=nt,v=At,A=bt,y=Gt),(Jt.equals(M)===!1||ct!==I)&&(n.blendColor(Jt.r,Jt.g,Jt.b,ct),M.copy(Jt),I=ct),m=z,L=!1}function Ve(z,ot){z.side===zn?Ht(n.CULL_FACE):Mt(n.CULL_FACE);let nt=z.side===Kn;ot&&(nt=!nt),cn(nt),z.blending===Mo&&z.transparent===!1?Ze(wr):Ze(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let At=z.stencilWrite;a.setTest(At),At&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),ve(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function cn(z){C!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),C=z)}function Ne(z){z!==Lm?(Mt(n.CULL_FACE),z!==D&&(z===cd?n.cullFace(n.BACK):z===Nm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),D=z}function En(z){z!==k&&(H&&n.lineWidth(z),k=z)}function ve(z,ot,nt){z?(Mt(n.POLYGON_OFFSET_FILL),(N!==ot||B!==nt)&&(N=ot,B=nt,o.getReversed()&&(ot=-ot,nt=-nt),n.polygonOffset(ot,nt))):Ht(n.POLYGON_OFFSET_FILL)}function _n(z){z?Mt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function je(z){z===void 0&&(z=n.TEXTURE0+W-1),Q!==z&&(n.activeTexture(z),Q=z)}function un(z,ot,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+W-1:nt=Q);let At=it[nt];At===void 0&&(At={type:void 0,texture:void 0},it[nt]=At),(At.type!==z||At.texture!==ot)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(z,ot||St[z]),At.type=z,At.texture=ot)}function G(){let z=it[Q];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(z){Qt("WebGLState:",z)}}function Zt(){try{n.compressedTexImage3D(...arguments)}catch(z){Qt("WebGLState:",z)}}function re(){try{n.texSubImage2D(...arguments)}catch(z){Qt("WebGLState:",z)}}function wt(){try{n.texSubImage3D(...arguments)}catch(z){Qt("WebGLState:",z)}}function ke(){try{n.compressedTexSubImage2D(...arguments)}catch(z){Qt("WebGLState:",z)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(z){Qt("WebGLState:",z)}}function Xt(){try{n.texStorage2D(...arguments)}catch(z){Qt("WebGLState:",z)}}function O(){try{n.texStorage3D(...arguments)}catch(z){Qt("WebGLState:",z)}}function T(){try{n.texImage2D(...arguments)}catch(z){Qt("WebGLState:",z)}}function q(){try{n.texImage3D(...arguments)}catch(z){Qt("WebGLState:",z)}}function ut(z){return h[z]!==void 0?h[z]:n.getParameter(z)}function at(z,ot){h[z]!==ot&&(n.pixelStorei(z,ot),h[z]=ot)}function _t(z){tt.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),tt.copy(z))}function yt(z){ht.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),ht.copy(z))}function et(z,ot){let nt=c.get(ot);nt===void 0&&(nt=new WeakMap,c.set(ot,nt));let At=nt.get(z);At===void 0&&(At=n.getUniformBlockIndex(ot,z.name),n.uniformBlockBinding(ot,At,At),nt.set(z,At))}function rt(z,ot,nt){let xt=c.get(ot).get(z);l[xt]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,nt),l[xt]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,it={},d={},l={},f=new WeakMap,p=[],x=null,g=!1,m=null,_=null,b=null,v=null,E=null,A=null,y=null,M=new $t(0,0,0),I=0,L=!1,C=null,D=null,k=null,N=null,B=null,tt.set(0,0,n.canvas.width,n.canvas.height),ht.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:he,setBlending:Ze,setMaterial:Ve,setFlipSided:cn,setCullFace:Ne,setLineWidth:En,setPolygonOffset:ve,setScissorTest:_n,activeTexture:je,bindTexture:un,unbindTexture:G,compressedTexImage2D:Rt,compressedTexImage3D:Zt,texImage2D:T,texImage3D:q,pixelStorei:at,getParameter:ut,updateUBOMapping:et,uniformBlockBinding:rt,texStorage2D:Xt,texStorage3D:O,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:ke,compressedTexSubImage3D:zt,scissor:_t,viewport:yt,reset:mt}}function pA(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(O=>p.delete(O)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(O,T){return g?new OffscreenCanvas(O,T):xa("canvas")}function _(O,T,q){let ut=1,at=Xt(O);if((at.width>q||at.height>q)&&(ut=q/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let _t=Math.floor(ut*at.width),yt=Math.floor(ut*at.height);d===void 0&&(d=m(_t,yt));let et=T?m(_t,yt):d;return et.width=_t,et.height=yt,et.getContext("2d").drawImage(O,0,0,_t,yt),qt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+_t+"x"+yt+")."),et}else return"data"in O&&qt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),O;return O}function b(O){return O.generateMipmaps}function v(O){n.generateMipmap(O)}function E(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(O,T,q,ut,at,_t=!1){if(O!==null){if(n[O]!==void 0)return n[O];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let yt;ut&&(yt=t.get("EXT_texture_norm16"),yt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=T;if(T===n.RED&&(q===n.FLOAT&&(et=n.R32F),q===n.HALF_FLOAT&&(et=n.R16F),q===n.UNSIGNED_BYTE&&(et=n.R8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),q===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),T===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.R8UI),q===n.UNSIGNED_SHORT&&(et=n.R16UI),q===n.UNSIGNED_INT&&(et=n.R32UI),q===n.BYTE&&(et=n.R8I),q===n.SHORT&&(et=n.R16I),q===n.INT&&(et=n.R32I)),T===n.RG&&(q===n.FLOAT&&(et=n.RG32F),q===n.HALF_FLOAT&&(et=n.RG16F),q===n.UNSIGNED_BYTE&&(et=n.RG8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),q===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),T===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RG8UI),q===n.UNSIGNED_SHORT&&(et=n.RG16UI),q===n.UNSIGNED_INT&&(et=n.RG32UI),q===n.BYTE&&(et=n.RG8I),q===n.SHORT&&(et=n.RG16I),q===n.INT&&(et=n.RG32I)),T===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGB8UI),q===n.UNSIGNED_SHORT&&(et=n.RGB16UI),q===n.UNSIGNED_INT&&(et=n.RGB32UI),q===n.BYTE&&(et=n.RGB8I),q===n.SHORT&&(et=n.RGB16I),q===n.INT&&(et=n.RGB32I)),T===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),q===n.UNSIGNED_INT&&(et=n.RGBA32UI),q===n.BYTE&&(et=n.RGBA8I),q===n.SHORT&&(et=n.RGBA16I),q===n.INT&&(et=n.RGBA32I)),T===n.RGB&&(q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),q===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),T===n.RGBA){let rt=_t?ga:_e.getTransfer(at);q===n.FLOAT&&(et=n.RGBA32F),q===n.HALF_FLOAT&&(et=n.RGBA16F),q===n.UNSIGNED_BYTE&&(et=rt===Ce?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),q===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(O,T){let q;return O?T===null||T===Li||T===Tr?q=n.DEPTH24_STENCIL8:T===Si?q=n.DEPTH32F_STENCIL8:T===Ao&&(q=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Li||T===Tr?q=n.DEPTH_COMPONENT24:T===Si?q=n.DEPTH_COMPONENT32F:T===Ao&&(q=n.DEPTH_COMPONENT16),q}function M(O,T){return b(O)===!0||O.isFramebufferTexture&&O.minFilter!==Nn&&O.minFilter!==Zn?Math.log2(Math.max(T.width,T.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?T.mipmaps.length:1}function I(O){let T=new WeakRef(O);i.get(O).__ref=T,p.add(T),x.register(O,T,T)}function L(O){let T=i.get(O).__ref;T!==void 0&&(p.delete(T),x.unregister(T))}function C(O){k(O.target)}function D(O){N(O.target)}function k(O){O.removeEventListener("dispose",C),L(O),W(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function N(O){O.removeEventListener("dispose",D),L(O),st(O)}function B(){for(let O of p){let T=O.deref();T!==void 0&&(T.isRenderTarget===!0?N(T):k(T))}p.clear(),h.clear()}function W(O){let T=i.get(O);if(T.__webglInit===void 0)return;let q=O.source,ut=f.get(q);if(ut){let at=ut[T.__cacheKey];at.usedTimes--,at.usedTimes===0&&H(O),Object.keys(ut).length===0&&f.delete(q)}i.remove(O)}function H(O){let T=i.get(O);n.deleteTexture(T.__webglTexture);let q=O.source,ut=f.get(q);delete ut[T.__cacheKey],o.memory.textures--}function st(O){let T=i.get(O);T.__depthDisposeCallback&&T.__depthDisposeCallback();let q=O.depthTexture;if(q&&q.renderTarget===O&&k(q),O.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(T.__webglFramebuffer[at]))for(let _t=0;_t<T.__webglFramebuffer[at].length;_t++)n.deleteFramebuffer(T.__webglFramebuffer[at][_t]);else n.deleteFramebuffer(T.__webglFramebuffer[at]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[at])}else{if(Array.isArray(T.__webglFramebuffer))for(let at=0;at<T.__webglFramebuffer.length;at++)n.deleteFramebuffer(T.__webglFramebuffer[at]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let at=0;at<T.__webglColorRenderbuffer.length;at++)T.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[at]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ut=O.textures;for(let at=0,_t=ut.length;at<_t;at++){let yt=i.get(ut[at]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ut[at])}i.remove(O)}let Y=0;function Q(){Y=0}function it(){return Y}function ft(O){Y=O}function dt(){let O=Y;return O>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,O}function tt(O){let T=[];return T.push(O.wrapS),T.push(O.wrapT),T.push(O.wrapR||0),T.push(O.magFilter),T.push(O.minFilter),T.push(O.anisotropy),T.push(O.internalFormat),T.push(O.format),T.push(O.type),T.push(O.generateMipmaps),T.push(O.mipmapsAutoUpdate),T.push(O.premultiplyAlpha),T.push(O.flipY),T.push(O.unpackAlignment),T.push(O.colorSpace),T.join()}function ht(O,T){let q=i.get(O);if(O.isVideoTexture&&ke(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&q.__version!==O.version){let ut=O.image;if(ut===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(q,O,T);return}}else O.isExternalTexture&&(q.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+T)}function gt(O,T){let q=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&q.__version!==O.version){Ve(q,O,T);return}else O.isExternalTexture&&(q.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+T)}function St(O,T){let q=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&q.__version!==O.version){Ve(q,O,T);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+T)}function Mt(O,T){let q=i.get(O);if(O.version>0&&q.__version!==O.version){cn(q,O,T);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+T)}let Ht={[Zl]:n.REPEAT,[Ji]:n.CLAMP_TO_EDGE,[Kl]:n.MIRRORED_REPEAT},se={[Nn]:n.NEAREST,[eg]:n.NEAREST_MIPMAP_NEAREST,[Ua]:n.NEAREST_MIPMAP_LINEAR,[Zn]:n.LINEAR,[Mc]:n.LINEAR_MIPMAP_NEAREST,[ws]:n.LINEAR_MIPMAP_LINEAR},Vt={[rg]:n.NEVER,[Nd]:n.ALWAYS,[og]:n.LESS,[Id]:n.LEQUAL,[ag]:n.EQUAL,[Ld]:n.GEQUAL,[lg]:n.GREATER,[cg]:n.NOTEQUAL};function he(O,T){if(T.type===Si&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===Zn||T.magFilter===Mc||T.magFilter===Ua||T.magFilter===ws||T.minFilter===Zn||T.minFilter===Mc||T.minFilter===Ua||T.minFilter===ws)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Ht[T.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Ht[T.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Ht[T.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,se[T.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,se[T.minFilter]),T.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,Vt[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Nn||T.minFilter!==Ua&&T.minFilter!==ws||T.type===Si&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(O,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function le(O,T){let q=!1;O.__webglInit===void 0&&(O.__webglInit=!0,T.addEventListener("dispose",C),I(T));let ut=T.source,at=f.get(ut);at===void 0&&(at={},f.set(ut,at));let _t=tt(T);if(_t!==O.__cacheKey){at[_t]===void 0&&(at[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[_t].usedTimes++;let yt=at[O.__cacheKey];yt!==void 0&&(at[O.__cacheKey].usedTimes--,yt.usedTimes===0&&H(T)),O.__cacheKey=_t,O.__webglTexture=at[_t].texture}return q}function ne(O,T,q){return Math.floor(Math.floor(O/q)/T)}function Ze(O,T,q,ut){let _t=O.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,q,ut,T.data);else{_t.sort((z,ot)=>z.start-ot.start);let yt=0;for(let z=1;z<_t.length;z++){let ot=_t[yt],nt=_t[z],At=ot.start+ot.count,xt=ne(nt.start,T.width,4),bt=ne(ot.start,T.width,4);nt.start<=At+1&&xt===bt&&ne(nt.start+nt.count-1,T.width,4)===xt?ot.count=Math.max(ot.count,nt.start+nt.count-ot.start):(++yt,_t[yt]=nt)}_t.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let z=0,ot=_t.length;z<ot;z++){let nt=_t[z],At=Math.floor(nt.start/4),xt=Math.ceil(nt.count/4),bt=At%T.width,Gt=Math.floor(At/T.width),Jt=xt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Gt,Jt,ct,q,ut,T.data)}O.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ve(O,T,q){let ut=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ut=n.TEXTURE_3D);let at=le(O,T),_t=T.source;e.bindTexture(ut,O.__webglTexture,n.TEXTURE0+q);let yt=i.get(_t);if(_t.version!==yt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ct=_e.getPrimaries(_e.workingColorSpace),kt=T.colorSpace===Es?null:_e.getPrimaries(T.colorSpace),jt=T.colorSpace===Es||ct===kt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt)}e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let rt=_(T.image,!1,s.maxTextureSize);rt=zt(T,rt);let mt=r.convert(T.format,T.colorSpace),z=r.convert(T.type),ot=A(T.internalFormat,mt,z,T.normalized,T.colorSpace,T.isVideoTexture);he(ut,T);let nt,At=T.mipmaps,xt=T.isVideoTexture!==!0,bt=yt.__version===void 0||at===!0,Gt=_t.dataReady,Jt=M(T,rt);if(T.isDepthTexture)ot=y(T.format===As,T.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,mt,z,null));else if(T.isDataTexture)if(At.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,ot,At[0].width,At[0].height);for(let ct=0,kt=At.length;ct<kt;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,z,nt.data):e.texImage2D(n.TEXTURE_2D,ct,ot,nt.width,nt.height,0,mt,z,nt.data);T.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,Jt,ot,rt.width,rt.height),Gt&&Ze(T,rt,mt,z)):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,mt,z,rt.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,ot,At[0].width,At[0].height,rt.depth);for(let ct=0,kt=At.length;ct<kt;ct++)if(nt=At[ct],T.format!==Di)if(mt!==null)if(xt){if(Gt)if(T.layerUpdates.size>0){let jt=Hd(nt.width,nt.height,T.format,T.type);for(let Ct of T.layerUpdates){let oe=nt.data.subarray(Ct*jt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*jt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,rt.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,ot,nt.width,nt.height,rt.depth,0,nt.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,rt.depth,mt,z,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,ot,nt.width,nt.height,rt.depth,0,mt,z,nt.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,ot,At[0].width,At[0].height);for(let ct=0,kt=At.length;ct<kt;ct++)nt=At[ct],T.format!==Di?mt!==null?xt?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,ot,nt.width,nt.height,0,nt.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,z,nt.data):e.texImage2D(n.TEXTURE_2D,ct,ot,nt.width,nt.height,0,mt,z,nt.data)}else if(T.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,ot,rt.width,rt.height,rt.depth),Gt)if(T.layerUpdates.size>0){let ct=Hd(rt.width,rt.height,T.format,T.type);for(let kt of T.layerUpdates){let jt=rt.data.subarray(kt*ct/rt.data.BYTES_PER_ELEMENT,(kt+1)*ct/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,kt,rt.width,rt.height,1,mt,z,jt)}T.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,mt,z,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,mt,z,rt.data);else if(T.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,Jt,ot,rt.width,rt.height,rt.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,mt,z,rt.data)):e.texImage3D(n.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,mt,z,rt.data);else if(T.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,Jt,ot,rt.width,rt.height);else{let ct=rt.width,kt=rt.height;for(let jt=0;jt<Jt;jt++)e.texImage2D(n.TEXTURE_2D,jt,ot,ct,kt,0,mt,z,null),ct>>=1,kt>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),rt.parentNode!==ct){ct.appendChild(rt),h.add(T),ct.onpaint=kt=>{let jt=kt.changedElements;for(let Ct of h)jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let jt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,jt,Ct,oe,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(xt&&bt){let ct=Xt(At[0]);e.texStorage2D(n.TEXTURE_2D,Jt,ot,ct.width,ct.height)}for(let ct=0,kt=At.length;ct<kt;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,z,nt):e.texImage2D(n.TEXTURE_2D,ct,ot,mt,z,nt);T.generateMipmaps=!1}else if(xt){if(bt){let ct=Xt(rt);e.texStorage2D(n.TEXTURE_2D,Jt,ot,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,z,rt)}else e.texImage2D(n.TEXTURE_2D,0,ot,mt,z,rt);b(T)&&T.mipmapsAutoUpdate===!0&&v(ut),yt.__version=_t.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function cn(O,T,q){if(T.image.length!==6)return;let ut=le(O,T),at=T.source;e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+q);let _t=i.get(at);if(at.version!==_t.__version||ut===!0){e.activeTexture(n.TEXTURE0+q);let yt=_e.getPrimaries(_e.workingColorSpace),et=T.colorSpace===Es?null:_e.getPrimaries(T.colorSpace),rt=T.colorSpace===Es||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let mt=T.isCompressedTexture||T.image[0].isCompressedTexture,z=T.image[0]&&T.image[0].isDataTexture,ot=[];for(let Ct=0;Ct<6;Ct++)!mt&&!z?ot[Ct]=_(T.image[Ct],!0,s.maxCubemapSize):ot[Ct]=z?T.image[Ct].image:T.image[Ct],ot[Ct]=zt(T,ot[Ct]);let nt=ot[0],At=r.convert(T.format,T.colorSpace),xt=r.convert(T.type),bt=A(T.internalFormat,At,xt,T.normalized,T.colorSpace),Gt=T.isVideoTexture!==!0,Jt=_t.__version===void 0||ut===!0,ct=at.dataReady,kt=M(T,nt);he(n.TEXTURE_CUBE_MAP,T);let jt;if(T.isDepthTexture){if(bt=y(T.format===As,T.type),Jt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,At,xt,null)}else if(mt){Gt&&Jt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){jt=ot[Ct].mipmaps;for(let oe=0;oe<jt.length;oe++){let Ge=jt[oe];T.format!==Di?At!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Ge.width,Ge.height,At,Ge.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Ge.width,Ge.height,0,Ge.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Ge.width,Ge.height,At,xt,Ge.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Ge.width,Ge.height,0,At,xt,Ge.data)}}}else{if(jt=T.mipmaps,Gt&&Jt){jt.length>0&&kt++;let Ct=Xt(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(z){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,ot[Ct].width,ot[Ct].height,At,xt,ot[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,ot[Ct].width,ot[Ct].height,0,At,xt,ot[Ct].data);for(let oe=0;oe<jt.length;oe++){let Gn=jt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Gn.width,Gn.height,At,xt,Gn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,Gn.width,Gn.height,0,At,xt,Gn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,At,xt,ot[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,At,xt,ot[Ct]);for(let oe=0;oe<jt.length;oe++){let Ge=jt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,At,xt,Ge.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,At,xt,Ge.image[Ct])}}}b(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),_t.__version=at.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function Ne(O,T,q,ut,at,_t){let yt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),rt=A(q.internalFormat,yt,et,q.normalized,q.colorSpace),mt=i.get(T),z=i.get(q);if(z.__renderTarget=T,!mt.__hasExternalTextures){let ot=Math.max(1,T.width>>_t),nt=Math.max(1,T.height>>_t);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,_t,rt,ot,nt,T.depth,0,yt,et,null):e.texImage2D(at,_t,rt,ot,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,O),wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,at,z.__webglTexture,0,re(T)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,at,z.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function En(O,T,q){if(n.bindRenderbuffer(n.RENDERBUFFER,O),T.depthBuffer){let ut=T.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,_t=y(T.stencilBuffer,at),yt=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(T),_t,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(T),_t,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,_t,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,O)}else{let ut=T.textures;for(let at=0;at<ut.length;at++){let _t=ut[at],yt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),rt=A(_t.internalFormat,yt,et,_t.normalized,_t.colorSpace);wt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(T),rt,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(T),rt,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,rt,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ve(O,T,q){let ut=T.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,O),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(T.depthTexture);at.__renderTarget=T;let _t=ut?T.depthTexture.image[0]:T.depthTexture.image;(!at.__webglTexture||_t.width!==T.width||_t.height!==T.height)&&(_t.width=T.width,_t.height=T.height,T.depthTexture.needsUpdate=!0),ut?Mt(T.depthTexture,0):ht(T.depthTexture,0);let yt=at.__webglTexture,et=re(T),rt=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,mt=T.depthTexture.format===As?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===xs)wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,rt,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,rt,yt,0);else if(T.depthTexture.format===As)wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,rt,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,rt,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function _n(O){let T=i.get(O),q=O.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==O.depthTexture){let ut=O.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ut){let at=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),T.__depthDisposeCallback=at}T.__boundDepthTexture=ut}if(O.depthTexture&&!T.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)ve(T.__webglFramebuffer[ut],O,ut);else O.texture.mipmaps.length>0?ve(T.__webglFramebuffer[0],O,0):ve(T.__webglFramebuffer,O,0);else if(q){T.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[ut]),T.__webglDepthbuffer[ut]===void 0)T.__webglDepthbuffer[ut]=n.createRenderbuffer(),En(T.__webglDepthbuffer[ut],O,!1);else{let at=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=T.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,_t)}}else if(O.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),En(T.__webglDepthbuffer,O,!1);else{let at=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function je(O,T,q){let ut=i.get(O);T!==void 0&&Ne(ut.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&_n(O)}function un(O){let T=O.texture,q=i.get(O),ut=i.get(T);O.addEventListener("dispose",D),I(O);let at=O.textures,_t=O.isWebGLCubeRenderTarget===!0,yt=at.length>1;if(yt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=T.version,o.memory.textures++),_t){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(T.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let rt=0;rt<T.mipmaps.length;rt++)q.__webglFramebuffer[et][rt]=n.createFramebuffer()}else q.__webglFramebuffer[et]=n.createFramebuffer()}else{if(T.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<T.mipmaps.length;et++)q.__webglFramebuffer[et]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,rt=at.length;et<rt;et++){let mt=i.get(at[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&wt(O)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<at.length;et++){let rt=at[et];q.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let mt=r.convert(rt.format,rt.colorSpace),z=r.convert(rt.type),ot=A(rt.internalFormat,mt,z,rt.normalized,rt.colorSpace,O.isXRRenderTarget===!0),nt=re(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,ot,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,q.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),En(q.__webglDepthRenderbuffer,O,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),he(n.TEXTURE_CUBE_MAP,T);for(let et=0;et<6;et++)if(T.mipmaps.length>0)for(let rt=0;rt<T.mipmaps.length;rt++)Ne(q.__webglFramebuffer[et][rt],O,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,rt);else Ne(q.__webglFramebuffer[et],O,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);b(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,rt=at.length;et<rt;et++){let mt=at[et],z=i.get(mt),ot=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ot=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,z.__webglTexture),he(ot,mt),Ne(q.__webglFramebuffer,O,mt,n.COLOR_ATTACHMENT0+et,ot,0),b(mt)&&v(ot)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(et=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ut.__webglTexture),he(et,T),T.mipmaps.length>0)for(let rt=0;rt<T.mipmaps.length;rt++)Ne(q.__webglFramebuffer[rt],O,T,n.COLOR_ATTACHMENT0,et,rt);else Ne(q.__webglFramebuffer,O,T,n.COLOR_ATTACHMENT0,et,0);b(T)?v(et):T.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}O.depthBuffer&&_n(O)}function G(O){let T=O.textures;for(let q=0,ut=T.length;q<ut;q++){let at=T[q];if(b(at)&&at.mipmapsAutoUpdate===!0){let _t=E(O),yt=i.get(at).__webglTexture;e.bindTexture(_t,yt),v(_t),e.unbindTexture()}}}let Rt=[];function Zt(O){if(O.samples>0){if(wt(O)===!1){let T=O.textures,q=O.width,ut=O.height,at=n.COLOR_BUFFER_BIT,_t=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(O),et=T.length>1;if(et)for(let mt=0;mt<T.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<T.length;mt++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let z=i.get(T[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,q,ut,0,0,q,ut,at,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Rt.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<T.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let z=i.get(T[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let T=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function re(O){return Math.min(s.maxSamples,O.samples)}function wt(O){let T=i.get(O);return O.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function ke(O){let T=o.render.frame;u.get(O)!==T&&(u.set(O,T),O.update())}function zt(O,T){let q=O.colorSpace,ut=O.format,at=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||q!==ma&&q!==Es&&(_e.getTransfer(q)===Ce?(ut!==Di||at!==ti)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",q)),T}function Xt(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=ft,this.setTexture2D=ht,this.setTexture2DArray=gt,this.setTexture3D=St,this.setTextureCube=Mt,this.rebindTextures=je,this.setupRenderTarget=un,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=Zt,this.setupDepthRenderbuffer=_n,this.setupFrameBufferTexture=Ne,this.useMultisampledRTT=wt,this.dispose=B}function mA(n,t){function e(i,s=Es){let r,o=_e.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===Ac)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ec)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ad)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ed)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Md)return n.BYTE;if(i===wd)return n.SHORT;if(i===Ao)return n.UNSIGNED_SHORT;if(i===wc)return n.INT;if(i===Li)return n.UNSIGNED_INT;if(i===Si)return n.FLOAT;if(i===Ni)return n.HALF_FLOAT;if(i===Td)return n.ALPHA;if(i===Cd)return n.RGB;if(i===Di)return n.RGBA;if(i===xs)return n.DEPTH_COMPONENT;if(i===As)return n.DEPTH_STENCIL;if(i===Tc)return n.RED;if(i===Cc)return n.RED_INTEGER;if(i===Qs)return n.RG;if(i===Rc)return n.RG_INTEGER;if(i===Pc)return n.RGBA_INTEGER;if(i===ka||i===Fa||i===Ba||i===za)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ka)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ka)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ba)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===za)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ic||i===Lc||i===Nc||i===Dc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ic)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Lc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Nc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Dc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Oc||i===Uc||i===kc||i===Fc||i===Bc||i===Va||i===zc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Oc||i===Uc)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===kc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Fc)return r.COMPRESSED_R11_EAC;if(i===Bc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Va)return r.COMPRESSED_RG11_EAC;if(i===zc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Vc||i===Gc||i===Hc||i===Wc||i===$c||i===Xc||i===qc||i===Yc||i===Zc||i===Kc||i===Jc||i===jc||i===Qc||i===tu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Vc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Gc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Hc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Wc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===$c)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Xc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===qc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Yc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Zc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Kc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Jc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===jc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Qc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===tu)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===eu||i===nu||i===iu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===eu)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===nu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===iu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===su||i===ru||i===Ga||i===ou)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===su)return r.COMPRESSED_RED_RGTC1_EXT;if(i===ru)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ga)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ou)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Tr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var gA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,xA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,jd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Ea(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Qi({vertexShader:gA,fragmentShader:xA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new gn(new Ta(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Qd=class extends Ii{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",g=new jd,m={},_=e.getContextAttributes(),b=null,v=null,E=[],A=[],y=new Yt,M=null,I=null,L=new Yn;L.viewport=new Fe;let C=new Yn;C.viewport=new Fe;let D=[L,C],k=new yc,N=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ht=E[tt];return ht===void 0&&(ht=new xo,E[tt]=ht),ht.getTargetRaySpace()},this.getControllerGrip=function(tt){let ht=E[tt];return ht===void 0&&(ht=new xo,E[tt]=ht),ht.getGripSpace()},this.getHand=function(tt){let ht=E[tt];return ht===void 0&&(ht=new xo,E[tt]=ht),ht.getHandSpace()};function W(tt){let ht=A.indexOf(tt.inputSource);if(ht===-1)return;let gt=E[ht];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",st);for(let tt=0;tt<E.length;tt++){let ht=A[tt];ht!==null&&(A[tt]=null,E[tt].disconnect(ht))}N=null,B=null,g.reset();for(let tt in m)delete m[tt];if(t.setRenderTarget(b),f=null,d=null,h=null,s=null,v=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(y.width,y.height,!1),I!==null){let tt=I.camera;tt.fov=I.fov,tt.zoom=I.zoom,tt.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",H),s.addEventListener("inputsourceschange",st),_.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,St=null,Mt=null;_.depth&&(Mt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=_.stencil?As:xs,St=_.stencil?Tr:Li);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new hi(d.textureWidth,d.textureHeight,{format:Di,type:ti,depthTexture:new Ss(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let gt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new hi(f.framebufferWidth,f.framebufferHeight,{format:Di,type:ti,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function st(tt){for(let ht=0;ht<tt.removed.length;ht++){let gt=tt.removed[ht],St=A.indexOf(gt);St>=0&&(A[St]=null,E[St].disconnect(gt))}for(let ht=0;ht<tt.added.length;ht++){let gt=tt.added[ht],St=A.indexOf(gt);if(St===-1){for(let Ht=0;Ht<E.length;Ht++)if(Ht>=A.length){A.push(gt),St=Ht;break}else if(A[Ht]===null){A[Ht]=gt,St=Ht;break}if(St===-1)break}let Mt=E[St];Mt&&Mt.connect(gt)}}function Y(tt,ht){ht===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ht.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ht=tt.near,gt=tt.far;g.texture!==null&&(g.depthNear>0&&(ht=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),k.near=C.near=L.near=ht,k.far=C.far=L.far=gt,(N!==k.near||B!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),N=k.near,B=k.far),k.layers.mask=tt.layers.mask|6,L.layers.mask=k.layers.mask&-5,C.layers.mask=k.layers.mask&-3;let St=tt.parent,Mt=k.cameras;Y(k,St);for(let Ht=0;Ht<Mt.length;Ht++)Y(Mt[Ht],St);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),I===null&&tt.isPerspectiveCamera&&(I={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,k,St)};function Q(tt,ht,gt){gt===null?tt.matrix.copy(ht.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ht.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ht.projectionMatrix),tt.projectionMatrixInverse.copy(ht.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=po*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(k)},this.getCameraTexture=function(tt){return m[tt]};let it=null;function ft(tt,ht){if(u=ht.getViewerPose(c||o),p=ht,u!==null){let gt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let St=!1;gt.length!==k.cameras.length&&(k.cameras.length=0,St=!0);for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt],le=null;if(f!==null)le=f.getViewport(he);else{let Ze=h.getViewSubImage(d,he);le=Ze.viewport,Vt===0&&(t.setRenderTargetTextures(v,Ze.colorTexture,Ze.depthStencilTexture),t.setRenderTarget(v))}let ne=D[Vt];ne===void 0&&(ne=new Yn,ne.layers.enable(Vt),ne.viewport=new Fe,D[Vt]=ne),ne.matrix.fromArray(he.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(he.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(le.x,le.y,le.width,le.height),Vt===0&&(k.matrix.copy(ne.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),St===!0&&k.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let Vt=h.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&g.init(Vt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&x){t.state.unbindTexture(),h=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt].camera;if(he){let le=m[he];le||(le=new Ea,m[he]=le);let ne=h.getCameraImage(he);le.sourceTexture=ne}}}}for(let gt=0;gt<E.length;gt++){let St=A[gt],Mt=E[gt];St!==null&&Mt!==void 0&&Mt.update(St,ht,c||o)}it&&it(tt,ht),ht.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ht}),p=null}let dt=new Gg;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},_A=new ae,jg=new te;jg.set(-1,0,0,0,1,0,0,0,1);function yA(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,zd(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,b,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),h(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,v)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,b):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Kn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Kn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=t.get(m),b=_.envMap,v=_.envMapRotation;b&&(g.envMap.value=b,g.envMapRotation.value.setFromMatrix4(_A.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(jg),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,b){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=b*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function h(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Kn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let _=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function vA(n,t,e,i){let s={},r={};function o(_,b){let v=b.program;i.uniformBlockBinding(_,v,s[_.id])}function a(_,b){let v=s[_.id];v===void 0&&(p(_),v=l(_),s[_.id]=v,_.addEventListener("dispose",g));let E=b.program;i.updateUBOMapping(_,E);let A=t.render.frame;r[_.id]!==A&&(c(_),r[_.id]=A)}function l(_){let b=n.createBuffer(),v=_.__size,E=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,v,E),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function c(_){let b=s[_.id],v=_.uniforms,E=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let A=0,y=v.length;A<y;A++){let M=v[A];if(Array.isArray(M))for(let I=0,L=M.length;I<L;I++)u(M[I],A,I,E);else u(M,A,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,b,v,E){if(d(_,b,v,E)===!0){let A=_.__offset,y=_.value;if(Array.isArray(y)){let M=0;for(let I=0;I<y.length;I++){let L=y[I],C=x(L,!0);h(L,_.__data,M),M+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function h(_,b,v){typeof _=="number"||typeof _=="boolean"?b[v]=_:_.isMatrix3?(b[v]=_.elements[0],b[v+1]=_.elements[1],b[v+2]=_.elements[2],b[v+3]=0,b[v+4]=_.elements[3],b[v+5]=_.elements[4],b[v+6]=_.elements[5],b[v+7]=0,b[v+8]=_.elements[6],b[v+9]=_.elements[7],b[v+10]=_.elements[8],b[v+11]=0):ArrayBuffer.isView(_)?b.set(_.subarray(0,b.length-v),v):_.toArray(b,v)}function d(_,b,v,E){let A=_.value,y=b+"_"+v;if(Array.isArray(A)){E[y]===void 0&&(E[y]=[]);let M=E[y],I=!1;for(let L=0;L<A.length;L++)f(A[L],M,L)===!0&&(I=!0);return I}return f(A,E,y)}function f(_,b,v){if(b[v]===void 0)return typeof _=="number"||typeof _=="boolean"?b[v]=_:ArrayBuffer.isView(_)?b[v]=_.slice():b[v]=_.clone(),!0;{let E=b[v];if(typeof _=="number"||typeof _=="boolean"){if(E!==_)return b[v]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(E.equals(_)===!1)return E.copy(_),!0}}return!1}function p(_){let b=_.uniforms,v=0,E=16;for(let y=0,M=b.length;y<M;y++){let I=Array.isArray(b[y])?b[y]:[b[y]];for(let L=0,C=I.length;L<C;L++){let D=I[L],k=Array.isArray(D.value)?D.value:[D.value],N=Array.isArray(b[y])||Array.isArray(D.value),B=v;for(let H=0,st=k.length;H<st;H++){let Y=k[H],Q=x(Y,N),it=v%E,ft=it%Q.boundary,dt=it+ft;v+=ft,dt!==0&&E-dt<Q.storage&&(v+=E-dt),H===0&&(B=v),v+=Q.storage}let W=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new W((v-B)/Float32Array.BYTES_PER_ELEMENT),D.__offset=B}}let A=v%E;return A>0&&(v+=E-A),_.__size=v,_.__cache={},this}function x(_,b){let v={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(v.boundary=4,v.storage=4):_.isVector2?(v.boundary=8,v.storage=8):_.isVector3||_.isColor?(v.boundary=16,v.storage=12):_.isVector4?(v.boundary=16,v.storage=16):_.isMatrix3?(v.boundary=16,v.storage=48):_.isMatrix4?(v.boundary=16,v.storage=64):_.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(v.boundary=16,v.storage=_.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",_),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(_){let b=_.target;b.removeEventListener("dispose",g),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function m(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var bA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),es=null;function SA(){return es===null&&(es=new Sa(bA,16,16,Qs,Ni),es.name="DFG_LUT",es.minFilter=Zn,es.magFilter=Zn,es.wrapS=Ji,es.wrapT=Ji,es.generateMipmaps=!1,es.needsUpdate=!0),es}var hu=class{constructor(t={}){let{canvas:e=hg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ti}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,g=new Set([Pc,Rc,Cc]),m=new Set([ti,Li,Ao,Tr,Ac,Ec]),_=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},E=null,A=null,y=[],M=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,C=!1,D=null,k=null,N=null,B=null;this._outputColorSpace=li;let W=0,H=0,st=null,Y=-1,Q=null,it=new Fe,ft=new Fe,dt=null,tt=new $t(0),ht=0,gt=e.width,St=e.height,Mt=1,Ht=null,se=null,Vt=new Fe(0,0,gt,St),he=new Fe(0,0,gt,St),le=!1,ne=new $s,Ze=new ec,Ve=!1,cn=!1,Ne=new ae,En=new V,ve=new Fe,_n={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},je=!1;function un(){return st===null?Mt:1}let G=i;function Rt(P,$){return e.getContext(P,$)}let Zt,re,wt,ke,zt,Xt,O,T,q,ut,at,_t,yt,et,rt,mt,z,ot,nt,At,xt,bt,Gt;try{let P={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),G===null){let $="webgl2";if(G=Rt($,P),G===null)throw Rt($)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Jt()}catch(P){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),Qt("WebGLRenderer: "+P.message),P}function Jt(){Zt=new Nw(G),Zt.init(),xt=new mA(G,Zt),re=new Sw(G,Zt,t,xt),wt=new fA(G,Zt),re.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),k=G.createFramebuffer(),N=G.createFramebuffer(),B=G.createFramebuffer(),ke=new Uw(G),zt=new Q1,Xt=new pA(G,Zt,wt,zt,re,xt,ke),O=new Lw(L),T=new Fb(G),bt=new vw(G,T),q=new Dw(G,T,ke,bt),ut=new Fw(G,q,T,bt,ke),ot=new kw(G,re,Xt),rt=new Mw(zt),at=new j1(L,O,Zt,re,bt,rt),_t=new yA(L,zt),yt=new eA,et=new aA(Zt),z=new yw(L,O,wt,ut,p,l),mt=new dA(L,ut,re),Gt=new vA(G,ke,re,wt),nt=new bw(G,Zt,ke),At=new Ow(G,Zt,ke),ke.programs=at.programs,L.capabilities=re,L.extensions=Zt,L.properties=zt,L.renderLists=yt,L.shadowMap=mt,L.state=wt,L.info=ke}x!==ti&&(I=new zw(x,e.width,e.height,a,s,r));let ct=new Qd(L,G);this.xr=ct,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let P=Zt.get("WEBGL_lose_context");P&&P.loseContext()},this.forceContextRestore=function(){let P=Zt.get("WEBGL_lose_context");P&&P.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(P){P!==void 0&&(Mt=P,this.setSize(gt,St,!1))},this.getSize=function(P){return P.set(gt,St)},this.setSize=function(P,$,j=!0){if(ct.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=P,St=$,e.width=Math.floor(P*Mt),e.height=Math.floor($*Mt),j===!0&&(e.style.width=P+"px",e.style.height=$+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,P,$)},this.getDrawingBufferSize=function(P){return P.set(gt*Mt,St*Mt).floor()},this.setDrawingBufferSize=function(P,$,j){gt=P,St=$,Mt=j,e.width=Math.floor(P*j),e.height=Math.floor($*j),this.setViewport(0,0,P,$)},this.setEffects=function(P){if(x===ti){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(P){for(let $=0;$<P.length;$++)if(P[$].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(P||[])},this.getCurrentViewport=function(P){return P.copy(it)},this.getViewport=function(P){return P.copy(Vt)},this.setViewport=function(P,$,j,Z){P.isVector4?Vt.set(P.x,P.y,P.z,P.w):Vt.set(P,$,j,Z),wt.viewport(it.copy(Vt).multiplyScalar(un()).round())},this.getScissor=function(P){return P.copy(he)},this.setScissor=function(P,$,j,Z){P.isVector4?he.set(P.x,P.y,P.z,P.w):he.set(P,$,j,Z),wt.scissor(ft.copy(he).multiplyScalar(un()).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(P){wt.setScissorTest(le=P)},this.setOpaqueSort=function(P){Ht=P},this.setTransparentSort=function(P){se=P},this.getClearColor=function(P){return P.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(P=!0,$=!0,j=!0){let Z=0;if(P){let K=!1;if(st!==null){let Et=st.texture.format;K=g.has(Et)}if(K){let Et=st.texture.type,Pt=m.has(Et),Tt=z.getClearColor(),It=z.getClearAlpha(),Bt=Tt.r,ee=Tt.g,de=Tt.b;Pt?(_[0]=Bt,_[1]=ee,_[2]=de,_[3]=It,G.clearBufferuiv(G.COLOR,0,_)):(b[0]=Bt,b[1]=ee,b[2]=de,b[3]=It,G.clearBufferiv(G.COLOR,0,b))}else Z|=G.COLOR_BUFFER_BIT}$&&(Z|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(P){P.setRenderer(this),D=P},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),z.dispose(),yt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),O.dispose(),ut.dispose(),q.dispose(),bt.dispose(),Gt.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",hl),ct.removeEventListener("sessionend",zi),rs.stop()};function kt(P){P.preventDefault(),Od("WebGLRenderer: Context Lost."),C=!0}function jt(){Od("WebGLRenderer: Context Restored."),C=!1;let P=ke.autoReset,$=mt.enabled,j=mt.autoUpdate,Z=mt.needsUpdate,K=mt.type;Jt(),ke.autoReset=P,mt.enabled=$,mt.autoUpdate=j,mt.needsUpdate=Z,mt.type=K}function Ct(P){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",P.statusMessage)}function oe(P){let $=P.target;$.removeEventListener("dispose",oe),Ge($)}function Ge(P){Gn(P),zt.remove(P)}function Gn(P){let $=zt.get(P).programs;$!==void 0&&($.forEach(function(j){at.releaseProgram(j)}),P.isShaderMaterial&&at.releaseShaderCache(P))}this.renderBufferDirect=function(P,$,j,Z,K,Et){$===null&&($=_n);let Pt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Tt=jo(P,$,j,Z,K);wt.setMaterial(Z,Pt);let It=j.index,Bt=1;if(Z.wireframe===!0){if(It=q.getWireframeAttribute(j),It===void 0)return;Bt=2}let ee=j.drawRange,de=j.attributes.position,Ft=ee.start*Bt,fe=(ee.start+ee.count)*Bt;Et!==null&&(Ft=Math.max(Ft,Et.start*Bt),fe=Math.min(fe,(Et.start+Et.count)*Bt)),It!==null?(Ft=Math.max(Ft,0),fe=Math.min(fe,It.count)):de!=null&&(Ft=Math.max(Ft,0),fe=Math.min(fe,de.count));let Je=fe-Ft;if(Je<0||Je===1/0)return;bt.setup(K,Z,Tt,j,It);let Pe,Ie=nt;if(It!==null&&(Pe=T.get(It),Ie=At,Ie.setIndex(Pe)),K.isMesh)Z.wireframe===!0?(wt.setLineWidth(Z.wireframeLinewidth*un()),Ie.setMode(G.LINES)):Ie.setMode(G.TRIANGLES);else if(K.isLine){let yn=Z.linewidth;yn===void 0&&(yn=1),wt.setLineWidth(yn*un()),K.isLineSegments?Ie.setMode(G.LINES):K.isLineLoop?Ie.setMode(G.LINE_LOOP):Ie.setMode(G.LINE_STRIP)}else K.isPoints?Ie.setMode(G.POINTS):K.isSprite&&Ie.setMode(G.TRIANGLES);if(K.isBatchedMesh)if(Zt.get("WEBGL_multi_draw"))Ie.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let yn=K._multiDrawStarts,Ot=K._multiDrawCounts,hn=K._multiDrawCount,xe=It?T.get(It).bytesPerElement:1,as=zt.get(Z).currentProgram.getUniforms();for(let dn=0;dn<hn;dn++)as.setValue(G,"_gl_DrawID",dn),Ie.render(yn[dn]/xe,Ot[dn])}else if(K.isInstancedMesh)Ie.renderInstances(Ft,Je,K.count);else if(j.isInstancedBufferGeometry){let yn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ot=Math.min(j.instanceCount,yn);Ie.renderInstances(Ft,Je,Ot)}else Ie.render(Ft,Je)};function Zo(P,$,j,Z){D!==null&&P.isNodeMaterial&&D.setObject(Z,P),Ve===!0&&rt.setState(P,j,!1),P.transparent===!0&&P.side===zn&&P.forceSinglePass===!1?(P.side=Kn,P.needsUpdate=!0,Vi(P,$,Z),P.side=js,P.needsUpdate=!0,Vi(P,$,Z),P.side=zn):Vi(P,$,Z)}this.compile=function(P,$,j=null){j===null&&(j=P),D!==null&&D.renderStart(P,$,j),A=et.get(j),A.init($),M.push(A),j.traverseVisible(function(K){K.isLight&&K.layers.test($.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),P!==j&&P.traverseVisible(function(K){K.isLight&&K.layers.test($.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),D!==null&&D.updateLights(A.state.lightsArray),cn=this.localClippingEnabled,Ve=rt.init(this.clippingPlanes,cn),Ve===!0&&rt.setGlobalState(this.clippingPlanes,$),D!==null&&mt.render(A.state.shadowsArray,j,$);let Z=new Set;return P.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Et=K.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];Zo(Tt,j,$,K),Z.add(Tt)}else Zo(Et,j,$,K),Z.add(Et)}),A=M.pop(),D!==null&&D.renderEnd(),Z},this.compileAsync=function(P,$,j=null){let Z=this.compile(P,$,j);return new Promise(K=>{function Et(){if(Z.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Z.delete(Pt)}),Z.size===0){K(P);return}setTimeout(Et,10)}Zt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Fr=null;function bh(P){Fr&&Fr(P)}function hl(){rs.stop()}function zi(){rs.start()}let rs=new Gg;rs.setAnimationLoop(bh),typeof self<"u"&&rs.setContext(self),this.setAnimationLoop=function(P){Fr=P,ct.setAnimationLoop(P),P===null?rs.stop():rs.start()},ct.addEventListener("sessionstart",hl),ct.addEventListener("sessionend",zi),this.render=function(P,$){if($!==void 0&&$.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;D!==null&&D.renderStart(P,$);let j=ct.enabled===!0&&ct.isPresenting===!0,Z=I!==null&&(st===null||j)&&I.begin(L,st);if(P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),$.parent===null&&$.matrixWorldAutoUpdate===!0&&$.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera($),$=ct.getCamera()),P.isScene===!0&&P.onBeforeRender(L,P,$,st),A=et.get(P,M.length),A.init($),A.state.textureUnits=Xt.getTextureUnits(),M.push(A),Ne.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),$.isArrayCamera?Ze.setFromArrayCamera($):ne.setFromProjectionMatrix(Ne,vi,$.reversedDepth),cn=this.localClippingEnabled,Ve=rt.init(this.clippingPlanes,cn),E=yt.get(P,y.length),E.init(),y.push(E),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=L.xr.getDepthSensingMesh();Pt!==null&&os(Pt,$,-1/0,L.sortObjects)}os(P,$,0,L.sortObjects),E.finish(),D!==null&&D.updateLights(A.state.lightsArray),L.sortObjects===!0&&E.sort(Ht,se),je=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,je&&z.addToRenderList(E,P),this.info.autoReset===!0&&this.info.reset(),Ve===!0&&rt.beginShadows();let K=A.state.shadowsArray;if(mt.render(K,P,$),Ve===!0&&rt.endShadows(),(Z&&I.hasRenderPass())===!1){let Pt=E.opaque,Tt=E.transmissive;if(A.setupLights(),$.isArrayCamera){let It=$.cameras;if(Tt.length>0)for(let Bt=0,ee=It.length;Bt<ee;Bt++){let de=It[Bt];Ai(Pt,Tt,P,de)}je&&z.render(P);for(let Bt=0,ee=It.length;Bt<ee;Bt++){let de=It[Bt];Ko(E,P,de,de.viewport)}}else Tt.length>0&&Ai(Pt,Tt,P,$),je&&z.render(P),Ko(E,P,$)}st!==null&&H===0&&(Xt.updateMultisampleRenderTarget(st),Xt.updateRenderTargetMipmap(st)),Z&&I.end(L),P.isScene===!0&&P.onAfterRender(L,P,$),bt.resetDefaultState(),Y=-1,Q=null,M.pop(),M.length>0?(A=M[M.length-1],Xt.setTextureUnits(A.state.textureUnits),Ve===!0&&rt.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,y.pop(),y.length>0?E=y[y.length-1]:E=null,D!==null&&D.renderEnd()};function os(P,$,j,Z){if(P.visible===!1)return;if(P.layers.test($.layers)){if(P.isGroup)j=P.renderOrder;else if(P.isLOD)P.autoUpdate===!0&&P.update($);else if(P.isLight)A.pushLight(P),P.castShadow&&A.pushShadow(P);else if(P.isSprite){let Pt=$.isArrayCamera?Ze:ne;if(!P.frustumCulled||P.intersectsFrustum(Pt)){Z&&ve.setFromMatrixPosition(P.matrixWorld).applyMatrix4(Ne);let Tt=ut.update(P),It=P.material;It.visible&&E.push(P,Tt,It,j,ve.z,null,$)}}else if(P.isMesh||P.isLine||P.isPoints){let Pt=$.isArrayCamera?Ze:ne;if(!P.frustumCulled||P.intersectsFrustum(Pt)){let Tt=ut.update(P),It=P.material;if(Z&&(P.boundingSphere!==void 0?(P.boundingSphere===null&&P.computeBoundingSphere(),ve.copy(P.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),ve.copy(Tt.boundingSphere.center)),ve.applyMatrix4(P.matrixWorld).applyMatrix4(Ne)),Array.isArray(It)){let Bt=Tt.groups;for(let ee=0,de=Bt.length;ee<de;ee++){let Ft=Bt[ee],fe=It[Ft.materialIndex];fe&&fe.visible&&E.push(P,Tt,fe,j,ve.z,Ft,$)}}else It.visible&&E.push(P,Tt,It,j,ve.z,null,$)}}}let Et=P.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)os(Et[Pt],$,j,Z)}function Ko(P,$,j,Z){let{opaque:K,transmissive:Et,transparent:Pt}=P;A.setupLightsView(j),Ve===!0&&rt.setGlobalState(L.clippingPlanes,j),Z&&wt.viewport(it.copy(Z)),K.length>0&&Qe(K,$,j),Et.length>0&&Qe(Et,$,j),Pt.length>0&&Qe(Pt,$,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ai(P,$,j,Z){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Z.id]===void 0){let Ft=Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Z.id]=new hi(1,1,{generateMipmaps:!0,type:Ft?Ni:ti,minFilter:ws,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Et=A.state.transmissionRenderTarget[Z.id],Pt=Z.viewport||it;Et.setSize(Pt.z*L.transmissionResolutionScale,Pt.w*L.transmissionResolutionScale);let Tt=L.getRenderTarget(),It=L.getActiveCubeFace(),Bt=L.getActiveMipmapLevel();L.setRenderTarget(Et),L.getClearColor(tt),ht=L.getClearAlpha(),ht<1&&L.setClearColor(16777215,.5),L.clear(),je&&z.render(j);let ee=L.toneMapping;L.toneMapping=ts;let de=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),A.setupLightsView(Z),Ve===!0&&rt.setGlobalState(L.clippingPlanes,Z),Qe(P,j,Z),Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let Ft=!1;for(let fe=0,Je=$.length;fe<Je;fe++){let Pe=$[fe],{object:Ie,geometry:yn,material:Ot,group:hn}=Pe;if(Ot.side===zn&&Ie.layers.test(Z.layers)){let xe=Ot.side;Ot.side=Kn,Ot.needsUpdate=!0,rn(Ie,j,Z,yn,Ot,hn),Ot.side=xe,Ot.needsUpdate=!0,Ft=!0}}Ft===!0&&(Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et))}L.setRenderTarget(Tt,It,Bt),L.setClearColor(tt,ht),de!==void 0&&(Z.viewport=de),L.toneMapping=ee}function Qe(P,$,j){let Z=$.isScene===!0?$.overrideMaterial:null;for(let K=0,Et=P.length;K<Et;K++){let Pt=P[K],{object:Tt,geometry:It,group:Bt}=Pt,ee=Pt.material;ee.allowOverride===!0&&Z!==null&&(ee=Z),Tt.layers.test(j.layers)&&rn(Tt,$,j,It,ee,Bt)}}function rn(P,$,j,Z,K,Et){D!==null&&K.isNodeMaterial&&D.setObject(P,K),P.onBeforeRender(L,$,j,Z,K,Et),P.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,P.matrixWorld),P.normalMatrix.getNormalMatrix(P.modelViewMatrix),K.onBeforeRender(L,$,j,Z,P,Et),K.transparent===!0&&K.side===zn&&K.forceSinglePass===!1?(K.side=Kn,K.needsUpdate=!0,L.renderBufferDirect(j,$,Z,K,P,Et),K.side=js,K.needsUpdate=!0,L.renderBufferDirect(j,$,Z,K,P,Et),K.side=zn):L.renderBufferDirect(j,$,Z,K,P,Et),P.onAfterRender(L,$,j,Z,K,Et)}function on(P){let $=0;for(let j of P)j.texture!==null&&$++;return $}function Vi(P,$,j){$.isScene!==!0&&($=_n);let Z=zt.get(P),K=A.state.lights,Et=A.state.shadowsArray,Pt=K.state.version,Tt=at.getParameters(P,K.state,Et,$,j,A.state.lightProbeGridArray),It=at.getProgramCacheKey(Tt),Bt=Z.programs;Z.environment=P.isMeshStandardMaterial||P.isMeshLambertMaterial||P.isMeshPhongMaterial?$.environment:null,Z.fog=$.fog;let ee=P.isMeshStandardMaterial||P.isMeshLambertMaterial&&!P.envMap||P.isMeshPhongMaterial&&!P.envMap;Z.envMap=O.get(P.envMap||Z.environment,ee),Z.envMapRotation=Z.environment!==null&&P.envMap===null?$.environmentRotation:P.envMapRotation,Bt===void 0&&(P.addEventListener("dispose",oe),Bt=new Map,Z.programs=Bt,Z.programVariants=new Map);let de=Bt.get(It);if(de!==void 0){if(Z.currentProgram===de&&Z.lightsStateVersion===Pt)return Jo(P,Tt),de}else Tt.uniforms=at.getUniforms(P),D!==null&&P.isNodeMaterial&&D.build(P,j,Tt),P.onBeforeCompile(Tt,L),de=at.acquireProgram(Tt,It),Bt.set(It,de),Z.uniforms=Tt.uniforms;let Ft=Z.uniforms;return(!P.isShaderMaterial&&!P.isRawShaderMaterial||P.clipping===!0)&&(Ft.clippingPlanes=rt.uniform),Jo(P,Tt),Z.needsLights=Ns(P),Z.lightsStateVersion=Pt,Z.needsLights&&(Ft.ambientLightColor.value=K.state.ambient,Ft.lightProbe.value=K.state.probe,Ft.sunLights.value=K.state.sun,Ft.sunLightShadows.value=K.state.sunShadow,Ft.directionalLights.value=K.state.directional,Ft.directionalLightShadows.value=K.state.directionalShadow,Ft.spotLights.value=K.state.spot,Ft.spotLightShadows.value=K.state.spotShadow,Ft.rectAreaLights.value=K.state.rectArea,Ft.ltc_1.value=K.state.rectAreaLTC1,Ft.ltc_2.value=K.state.rectAreaLTC2,Ft.pointLights.value=K.state.point,Ft.pointLightShadows.value=K.state.pointShadow,Ft.hemisphereLights.value=K.state.hemi,Ft.sunShadowMatrix.value=K.state.sunShadowMatrix,Ft.sunShadowCascade.value=K.state.sunShadowCascade,Ft.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ft.spotLightMatrix.value=K.state.spotLightMatrix,Ft.spotLightMap.value=K.state.spotLightMap,Ft.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=on(A.state.lightProbeGridArray),Z.currentProgram=de,Z.uniformsList=null,de}function ni(P,$,j,Z,K){let Et=zt.get(P),Pt=Et.currentProgram.id+","+Z+","+K,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=Vi(P,$,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=Z,Et.toneMapping=K),Tt}function Ls(P){if(P.uniformsList===null){let $=P.currentProgram.getUniforms();P.uniformsList=To.seqWithValue($.seq,P.uniforms)}return P.uniformsList}function Jo(P,$){let j=zt.get(P);j.outputColorSpace=$.outputColorSpace,j.batching=$.batching,j.batchingColor=$.batchingColor,j.instancing=$.instancing,j.instancingColor=$.instancingColor,j.instancingMorph=$.instancingMorph,j.skinning=$.skinning,j.morphTargets=$.morphTargets,j.morphNormals=$.morphNormals,j.morphColors=$.morphColors,j.morphTargetsCount=$.morphTargetsCount,j.numClippingPlanes=$.numClippingPlanes,j.numIntersection=$.numClipIntersection,j.vertexAlphas=$.vertexAlphas,j.vertexTangents=$.vertexTangents,j.toneMapping=$.toneMapping}function jo(P,$,j,Z,K){$.isScene!==!0&&($=_n),Xt.resetTextureUnits();let Et=$.fog,Pt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?$.environment:null,Tt=st===null?L.outputColorSpace:st.isXRRenderTarget===!0?st.texture.colorSpace:_e.workingColorSpace,It=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Bt=O.get(Z.envMap||Pt,It),ee=Z.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,de=!!j.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ft=!!j.morphAttributes.position,fe=!!j.morphAttributes.normal,Je=!!j.morphAttributes.color,Pe=ts;Z.toneMapped&&(st===null||st.isXRRenderTarget===!0)&&(Pe=L.toneMapping);let Ie=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,yn=Ie!==void 0?Ie.length:0,Ot=zt.get(Z),hn=A.state.lights;if(Ve===!0&&(cn===!0||P!==Q)){let Le=P===Q&&Z.id===Y;rt.setState(Z,P,Le)}let xe=!1,as=!1;Z.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==hn.state.version||K.isBatchedMesh&&Ot.batching===!1||!K.isBatchedMesh&&Ot.batching===!0||K.isBatchedMesh&&Ot.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ot.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ot.instancing===!1||!K.isInstancedMesh&&Ot.instancing===!0||K.isSkinnedMesh&&Ot.skinning===!1||!K.isSkinnedMesh&&Ot.skinning===!0||K.isInstancedMesh&&Ot.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ot.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ot.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ot.instancingMorph===!1&&K.morphTexture!==null||Ot.envMap!==Bt||Z.fog===!0&&Ot.fog!==Et||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==rt.numPlanes||Ot.numIntersection!==rt.numIntersection)||Ot.vertexAlphas!==ee||Ot.vertexTangents!==de||Ot.morphTargets!==Ft||Ot.morphNormals!==fe||Ot.morphColors!==Je||Ot.morphTargetsCount!==yn||Ot.numLightProbeGrids!==on(A.state.lightProbeGridArray)?xe=!0:(Ot.outputColorSpace!==Tt||Ot.toneMapping!==Pe)&&(as=!0):(xe=!0,Ot.__version=Z.version);let dn=Ot.currentProgram;(xe===!0||as===!0)&&(dn=as===!0?ni(Z,$,K,Tt,Pe):Vi(Z,$,K),D&&Z.isNodeMaterial&&D.onUpdateProgram(Z,dn,Ot));let Vr=!1,Gi=!1,ls=!1,ce=dn.getUniforms(),tn=Ot.uniforms;if(wt.useProgram(dn.program)&&(Vr=!0,Gi=!0,ls=!0),Z.id!==Y&&(Y=Z.id,Gi=!0),Vr||Q!==P){wt.buffers.depth.getReversed()&&P.reversedDepth!==!0&&(P._reversedDepth=!0,P.updateProjectionMatrix()),ce.setValue(G,"projectionMatrix",P.projectionMatrix),ce.setValue(G,"viewMatrix",P.matrixWorldInverse);let fn=ce.map.cameraPosition;fn!==void 0&&fn.setValue(G,En.setFromMatrixPosition(P.matrixWorld)),re.logarithmicDepthBuffer&&ce.setValue(G,"logDepthBufFC",2/(Math.log(P.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ce.setValue(G,"isOrthographic",P.isOrthographicCamera===!0),Q!==P&&(Q=P,Gi=!0,ls=!0)}if(Ot.needsLights&&(hn.state.sunShadowMap.length>0&&ce.setValue(G,"sunShadowMap",hn.state.sunShadowMap,Xt),hn.state.directionalShadowMap.length>0&&ce.setValue(G,"directionalShadowMap",hn.state.directionalShadowMap,Xt),hn.state.spotShadowMap.length>0&&ce.setValue(G,"spotShadowMap",hn.state.spotShadowMap,Xt),hn.state.pointShadowMap.length>0&&ce.setValue(G,"pointShadowMap",hn.state.pointShadowMap,Xt)),K.isSkinnedMesh){ce.setOptional(G,K,"bindMatrix"),ce.setOptional(G,K,"bindMatrixInverse");let Le=K.skeleton;Le&&(Le.boneTexture===null&&Le.computeBoneTexture(),ce.setValue(G,"boneTexture",Le.boneTexture,Xt))}K.isBatchedMesh&&(ce.setOptional(G,K,"batchingTexture"),ce.setValue(G,"batchingTexture",K._matricesTexture,Xt),ce.setOptional(G,K,"batchingIdTexture"),ce.setValue(G,"batchingIdTexture",K._indirectTexture,Xt),ce.setOptional(G,K,"batchingColorTexture"),K._colorsTexture!==null&&ce.setValue(G,"batchingColorTexture",K._colorsTexture,Xt));let Hn=j.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&ot.update(K,j,dn),(Gi||Ot.receiveShadow!==K.receiveShadow)&&(Ot.receiveShadow=K.receiveShadow,ce.setValue(G,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&$.environment!==null&&(tn.envMapIntensity.value=$.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=SA()),Gi){if(ce.setValue(G,"toneMappingExposure",L.toneMappingExposure),Ot.needsLights&&Br(tn,ls),Et&&Z.fog===!0&&_t.refreshFogUniforms(tn,Et),_t.refreshMaterialUniforms(tn,Z,Mt,St,A.state.transmissionRenderTarget[P.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Le=v,fn=0;for(let kn of A.state.lightProbeGridArray)kn.texture!==null&&(Le.textures[fn]=kn.texture,Le.min[fn]=kn.boundingBox.min,Le.max[fn]=kn.boundingBox.max,Le.resolution[fn]=kn.resolution,fn++);for(let kn in Le)Le[kn].length=fn;tn.probesSH.value=Le.textures,tn.probesMin.value=Le.min,tn.probesMax.value=Le.max,tn.probesResolution.value=Le.resolution}To.upload(G,Ls(Ot),tn,Xt)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(To.upload(G,Ls(Ot),tn,Xt),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ce.setValue(G,"center",K.center),ce.setValue(G,"modelViewMatrix",K.modelViewMatrix),ce.setValue(G,"normalMatrix",K.normalMatrix),ce.setValue(G,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let Le=Z.uniformsGroups;for(let fn=0,kn=Le.length;fn<kn;fn++){let dl=Le[fn];Gt.update(dl,dn),Gt.bind(dl,dn)}}return dn}function Br(P,$){P.ambientLightColor.needsUpdate=$,P.lightProbe.needsUpdate=$,P.sunLights.needsUpdate=$,P.sunLightShadows.needsUpdate=$,P.directionalLights.needsUpdate=$,P.directionalLightShadows.needsUpdate=$,P.pointLights.needsUpdate=$,P.pointLightShadows.needsUpdate=$,P.spotLights.needsUpdate=$,P.spotLightShadows.needsUpdate=$,P.rectAreaLights.needsUpdate=$,P.hemisphereLights.needsUpdate=$}function Ns(P){return P.isMeshLambertMaterial||P.isMeshToonMaterial||P.isMeshPhongMaterial||P.isMeshStandardMaterial||P.isShadowMaterial||P.isShaderMaterial&&P.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return st},this.setRenderTargetTextures=function(P,$,j){let Z=zt.get(P);Z.__autoAllocateDepthBuffer=P.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),zt.get(P.texture).__webglTexture=$,zt.get(P.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:j,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(P,$){let j=zt.get(P);j.__webglFramebuffer=$,j.__useDefaultFramebuffer=$===void 0},this.setRenderTarget=function(P,$=0,j=0){st=P,W=$,H=j;let Z=null,K=!1,Et=!1;if(P){let Tt=zt.get(P);if(Tt.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(G.FRAMEBUFFER,Tt.__webglFramebuffer),it.copy(P.viewport),ft.copy(P.scissor),dt=P.scissorTest,wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),Y=-1;return}else if(Tt.__webglFramebuffer===void 0)Xt.setupRenderTarget(P);else if(Tt.__hasExternalTextures)Xt.rebindTextures(P,zt.get(P.texture).__webglTexture,zt.get(P.depthTexture).__webglTexture);else if(P.depthBuffer){let ee=P.depthTexture;if(Tt.__boundDepthTexture!==ee){if(ee!==null&&zt.has(ee)&&(P.width!==ee.image.width||P.height!==ee.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(P)}}let It=P.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(P).__webglFramebuffer;P.isWebGLCubeRenderTarget?(Array.isArray(Bt[$])?Z=Bt[$][j]:Z=Bt[$],K=!0):P.samples>0&&Xt.useMultisampledRTT(P)===!1?Z=zt.get(P).__webglMultisampledFramebuffer:Array.isArray(Bt)?Z=Bt[j]:Z=Bt,it.copy(P.viewport),ft.copy(P.scissor),dt=P.scissorTest}else it.copy(Vt).multiplyScalar(Mt).floor(),ft.copy(he).multiplyScalar(Mt).floor(),dt=le;if(j!==0&&(Z=k),wt.bindFramebuffer(G.FRAMEBUFFER,Z)&&wt.drawBuffers(P,Z),wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),K){let Tt=zt.get(P.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+$,Tt.__webglTexture,j)}else if(Et){let Tt=$;for(let It=0;It<P.textures.length;It++){let Bt=zt.get(P.textures[It]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(P!==null&&j!==0){let Tt=zt.get(P.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,Tt.__webglTexture,j)}Y=-1};function zr(P){let $=zt.get(P);return($.__readFormat!==P.format||$.__readType!==P.type)&&($.__readFormat=P.format,$.__readType=P.type,$.__formatReadable=re.textureFormatReadable(P.format),$.__typeReadable=re.textureTypeReadable(P.type)),$}this.readRenderTargetPixels=function(P,$,j,Z,K,Et,Pt,Tt=0){if(!(P&&P.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(G.FRAMEBUFFER,It);try{let Bt=P.textures[Tt],ee=Bt.format,de=Bt.type;P.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Tt);let Ft=zr(Bt);if(Ft.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ft.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}$>=0&&$<=P.width-Z&&j>=0&&j<=P.height-K&&G.readPixels($,j,Z,K,xt.convert(ee),xt.convert(de),Et)}finally{let Bt=st!==null?zt.get(st).__webglFramebuffer:null;wt.bindFramebuffer(G.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(P,$,j,Z,K,Et,Pt,Tt=0){if(!(P&&P.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(P).__webglFramebuffer;if(P.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if($>=0&&$<=P.width-Z&&j>=0&&j<=P.height-K){wt.bindFramebuffer(G.FRAMEBUFFER,It);let Bt=P.textures[Tt],ee=Bt.format,de=Bt.type;P.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Tt);let Ft=zr(Bt);if(Ft.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ft.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let fe=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,fe),G.bufferData(G.PIXEL_PACK_BUFFER,Et.byteLength,G.STREAM_READ),G.readPixels($,j,Z,K,xt.convert(ee),xt.convert(de),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let Je=st!==null?zt.get(st).__webglFramebuffer:null;wt.bindFramebuffer(G.FRAMEBUFFER,Je);let Pe=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await fg(G,Pe,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,fe),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Et),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(fe),G.deleteSync(Pe),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(P,$=null,j=0){let Z=Math.pow(2,-j),K=Math.floor(P.image.width*Z),Et=Math.floor(P.image.height*Z),Pt=$!==null?$.x:0,Tt=$!==null?$.y:0;Xt.setTexture2D(P,0),G.copyTexSubImage2D(G.TEXTURE_2D,j,0,0,Pt,Tt,K,Et),wt.unbindTexture()},this.copyTextureToTexture=function(P,$,j=null,Z=null,K=0,Et=0){let Pt,Tt,It,Bt,ee,de,Ft,fe,Je,Pe=P.isCompressedTexture?P.mipmaps[Et]:P.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,ee=j.min.y,de=j.isBox3?j.min.z:0;else{let ce=Math.pow(2,-K);Pt=Math.floor(Pe.width*ce),Tt=Math.floor(Pe.height*ce),P.isDataArrayTexture?It=Pe.depth:P.isData3DTexture?It=Math.floor(Pe.depth*ce):It=1,Bt=0,ee=0,de=0}Z!==null?(Ft=Z.x,fe=Z.y,Je=Z.z):(Ft=0,fe=0,Je=0);let Ie=xt.convert($.format),yn=xt.convert($.type),Ot;$.isData3DTexture?(Xt.setTexture3D($,0),Ot=G.TEXTURE_3D):$.isDataArrayTexture||$.isCompressedArrayTexture?(Xt.setTexture2DArray($,0),Ot=G.TEXTURE_2D_ARRAY):(Xt.setTexture2D($,0),Ot=G.TEXTURE_2D),wt.activeTexture(G.TEXTURE0),wt.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,$.flipY),wt.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,$.premultiplyAlpha),wt.pixelStorei(G.UNPACK_ALIGNMENT,$.unpackAlignment);let hn=wt.getParameter(G.UNPACK_ROW_LENGTH),xe=wt.getParameter(G.UNPACK_IMAGE_HEIGHT),as=wt.getParameter(G.UNPACK_SKIP_PIXELS),dn=wt.getParameter(G.UNPACK_SKIP_ROWS),Vr=wt.getParameter(G.UNPACK_SKIP_IMAGES);wt.pixelStorei(G.UNPACK_ROW_LENGTH,Pe.width),wt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Pe.height),wt.pixelStorei(G.UNPACK_SKIP_PIXELS,Bt),wt.pixelStorei(G.UNPACK_SKIP_ROWS,ee),wt.pixelStorei(G.UNPACK_SKIP_IMAGES,de);let Gi=P.isDataArrayTexture||P.isData3DTexture,ls=$.isDataArrayTexture||$.isData3DTexture;if(P.isDepthTexture){let ce=zt.get(P),tn=zt.get($),Hn=zt.get(ce.__renderTarget),Le=zt.get(tn.__renderTarget);wt.bindFramebuffer(G.READ_FRAMEBUFFER,Hn.__webglFramebuffer),wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,Le.__webglFramebuffer);for(let fn=0;fn<It;fn++)Gi&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,zt.get(P).__webglTexture,K,de+fn),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,zt.get($).__webglTexture,Et,Je+fn)),G.blitFramebuffer(Bt,ee,Bt+Pt,ee+Tt,Ft,fe,Ft+Pt,fe+Tt,G.DEPTH_BUFFER_BIT,G.NEAREST);wt.bindFramebuffer(G.READ_FRAMEBUFFER,null),wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(K!==0||P.isRenderTargetTexture||zt.has(P)){let ce=zt.get(P),tn=zt.get($);wt.bindFramebuffer(G.READ_FRAMEBUFFER,N),wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,B);for(let Hn=0;Hn<It;Hn++)Gi?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,ce.__webglTexture,K,de+Hn):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,ce.__webglTexture,K),ls?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,tn.__webglTexture,Et,Je+Hn):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,tn.__webglTexture,Et),K!==0?G.blitFramebuffer(Bt,ee,Bt+Pt,ee+Tt,Ft,fe,Ft+Pt,fe+Tt,G.COLOR_BUFFER_BIT,G.NEAREST):ls?G.copyTexSubImage3D(Ot,Et,Ft,fe,Je+Hn,Bt,ee,Pt,Tt):G.copyTexSubImage2D(Ot,Et,Ft,fe,Bt,ee,Pt,Tt);wt.bindFramebuffer(G.READ_FRAMEBUFFER,null),wt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else ls?P.isDataTexture||P.isData3DTexture?G.texSubImage3D(Ot,Et,Ft,fe,Je,Pt,Tt,It,Ie,yn,Pe.data):$.isCompressedArrayTexture?G.compressedTexSubImage3D(Ot,Et,Ft,fe,Je,Pt,Tt,It,Ie,Pe.data):G.texSubImage3D(Ot,Et,Ft,fe,Je,Pt,Tt,It,Ie,yn,Pe):P.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Et,Ft,fe,Pt,Tt,Ie,yn,Pe.data):P.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Et,Ft,fe,Pe.width,Pe.height,Ie,Pe.data):G.texSubImage2D(G.TEXTURE_2D,Et,Ft,fe,Pt,Tt,Ie,yn,Pe);wt.pixelStorei(G.UNPACK_ROW_LENGTH,hn),wt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,xe),wt.pixelStorei(G.UNPACK_SKIP_PIXELS,as),wt.pixelStorei(G.UNPACK_SKIP_ROWS,dn),wt.pixelStorei(G.UNPACK_SKIP_IMAGES,Vr),Et===0&&$.generateMipmaps===!0&&$.mipmapsAutoUpdate===!0&&G.generateMipmap(Ot),wt.unbindTexture()},this.initRenderTarget=function(P){zt.get(P).__webglFramebuffer===void 0&&Xt.setupRenderTarget(P)},this.initTexture=function(P){P.isCubeTexture?Xt.setTextureCube(P,0):P.isData3DTexture?Xt.setTexture3D(P,0):P.isDataArrayTexture||P.isCompressedArrayTexture?Xt.setTexture2DArray(P,0):Xt.setTexture2D(P,0),wt.unbindTexture()},this.resetState=function(){W=0,H=0,st=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};function Rr(n){let t=new Ms;return t.userData.nearer=n,n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function Ro(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let x=0;x<3;x++)s[r+12+x]=(n[t+x]+n[e+x])/2;s[r+15]=1}var pu="#d55e00",mu="#0072b2",Qg=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"],t0=["#735826","#54458a","#35693a","#8c4467","#0b5a8a","#525252"];function n0(n){return t0[n%t0.length]}function Ya(n){return Qg[n%Qg.length]}var MA=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],wA=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],AA=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function ef(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var Po=ef(MA),i0=ef(wA),gu=ef(AA),tf=null;function me(n){return getComputedStyle(tf??document.documentElement).getPropertyValue(n).trim()}function nf(){let n=document.createElement("div");return n.className="paper",document.body.append(n),tf=n,()=>{tf=null,n.remove()}}function s0(n){let t=nf();try{return n()}finally{t()}}function tr(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var e0=[[],[8,4],[8,3,2,3],[2,3]],EA=7;function Oi(n){return{colour:me(`--line-${n%EA}`),dash:e0[n%e0.length]}}var TA=32767,er=24,CA=5/3*Math.PI,RA=.22,sf=.11,r0=.7,o0=3,a0=1e-6;function l0(n){let t=n.turns.map(l=>({...l,pivot:qe(l.pivot,Float32Array),axis:Float32Array.from(qe(l.axis,Int16Array),c=>c/TA),left:l.left&&qe(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&qe(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:qe(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function c0({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function u0(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(I=>I.radius)),c=.05*n.mesh.span_m,u=Rr(Math.max(l,c)),h=new di(new bi(1,1,1,10),u,e.length*er+i.length),d=new di(new Sr(1,1,16),u,e.length+i.length),f=new Ln;for(let I of[h,d])I.frustumCulled=!1,f.add(I);let p=new Float32Array(3*(er+2)),[x,g]=[0,0],m=(I,L,C,D,k)=>Ro(p,3*L,3*C,D,I.instanceMatrix.array,16*k);function _(I,L){for(let C=0;C<3;C++)p[3*I+C]=L[C]}function b(I,L,C,D){let[k,N]=Pr(t,C),W=(I.left?rf(I.left,1,k,N)[0]:1)*r(I.shares,D)/o;if(!(Math.abs(W)>a0))return;let[H,st]=I.ends?PA(L,I.ends):[I.pivot,I.axis].map(ht=>rf(ht,3,k,N)),Y=LA(st,I),Q=IA(st,Y),it=CA*Math.min(1.2,Math.abs(W))*Math.sign(W),ft=ht=>H.map((gt,St)=>gt+I.radius*(Math.cos(ht)*Y[St]+Math.sin(ht)*Q[St]));for(let ht=0;ht<=er;ht++)_(ht,ft(it*(ht/er-.5)));let dt=it/2;_(er+1,ft(dt+Math.sign(W)*r0));let tt=sf*I.radius;for(let ht=0;ht<er;ht++)m(h,ht,ht+1,tt,x++);m(d,er,er+1,o0*tt,g++)}function v(I,L,C,D){let[k,N]=Pr(t,C),B=I.force?rf(I.force,1,k,N)[0]:r(I.shares,D)/a;if(!(Math.abs(B)>a0))return;let W=RA*n.mesh.span_m*B,H=L.subarray(3*I.point,3*I.point+3),st=Y=>I.direction.map((Q,it)=>H[it]+Y*Q);_(0,H),_(1,st(W)),_(2,st(W+Math.sign(B)*r0*c)),m(h,0,1,sf*c,x++),m(d,1,2,o0*sf*c,g++)}function E(I){[x,g]=[0,0];let L=s(I),C=n.pointsAt(I);for(let D of e)b(D,C,I,L);for(let D of i)v(D,C,I,L);[h.count,d.count]=[x,g];for(let D of[h,d])D.instanceMatrix.needsUpdate=!0}let A=()=>u.color.set(new $t(me("--effort")));function y(){for(let I of[h,d])I.dispose(),I.geometry.dispose();u.dispose()}return{group:f,pose:E,paint:A,count:()=>g,dispose:y}}function rf(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function PA(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function IA(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function LA(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var Ts="tendon energy",af=Symbol("readings of single creases");function qe(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function h0({low:n,step:t,steps:e}){return Float32Array.from(qe(e,Uint16Array),(i,s)=>n[s%n.length]+t[s%n.length]*i)}function Jn(n){let t=qe(n.time,Float64Array),e=typeof n.points=="string"?qe(n.points,Float32Array):h0(n.points),i=3*n.pointCount,s={[Ts]:{width:n.tendonParts.length,values:qe(n.tendonEnergy_J,Float32Array)}};for(let _ of n.readings)s[_.name]={width:_.parts.length,values:qe(_.values,Float32Array)};let{creases:r=null}=n,o=(n.along??[]).map(_=>({..._,key:Symbol(_.name)}));for(let{key:_,values:b}of o)s[_]={width:1,values:qe(b,Float32Array)};r&&(s[af]={width:r.values.low.length,values:h0(r.values)});let a=Int32Array.from(n.between),l=Float64Array.from(n.share),c=new Float32Array(i);function u(_,b=c){return of(t,e,i,_,b),b}function h(_,b=new Float32Array(3*l.length)){return d(u(_),b)}function d(_,b){for(let v=0;v<l.length;v++){let E=3*a[2*v],A=3*a[2*v+1];for(let y=0;y<3;y++){let M=_[E+y];b[3*v+y]=M+l[v]*(_[A+y]-M)}}return b}function f(_,b,v=new Float32Array(s[_].width)){return of(t,s[_].values,s[_].width,b,v),v}function p(_,b){let{width:v,values:E}=s[_];return Float32Array.from(t,(A,y)=>E[y*v+b])}let x=qe(n.restLength_m,Float32Array);function g(_,b){x.length===b.length?b.set(x):of(t,x,b.length,_,b)}let m=n.efforts&&l0(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,m?.pushes.length?.12*n.span_m:0,...(m?.turns??[]).map(_=>.4*_.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,along:o,creases:r,time:t,start:t[0],end:t[t.length-1],efforts:m,strained:n.built!==null,stressed:!!n.membraneLaw,builtVertices:()=>d(qe(n.built,Float32Array),new Float32Array(3*l.length)),restLengthsAt:g,pointsAt:u,verticesAt:h,verticesOf:d,valuesAt:f,line:p,stageAt:_=>n.stages.findLast(b=>b.start<=_)??n.stages[0],markAt:_=>n.marks.find(b=>Math.abs(b.time-_)<1e-9)}}function of(n,t,e,i,s){let[r,o]=Pr(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let u=t[a+c];s[c]=o===0?u:u+o*(t[l+c]-u)}}function Pr(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}function nr(n,t,e){let[i,s]=Pr(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}function xu(){return document.getElementById("engine-program")!==null}async function Io(n,t){let e=new Blob([qe(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):t(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),t({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n}),f={first:h,version:d,ask:l,send:x=>r.postMessage(x),take:p,end:c};return f;async function p(x,g){let{frame:m}=await l({act:"load",text:x});return t=g,{...f,first:m}}}catch(u){throw c(),u}}var d0={type:"change"},cf={type:"start"},p0={type:"end"},_u=new Ws,f0=new ci,NA=Math.cos(70*Bd.DEG2RAD),Mn=new V,ei=2*Math.PI,Ae={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},lf=1e-6,yu=class extends Da{constructor(t,e=null){super(t,e),this.state=Ae.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ks.ROTATE,MIDDLE:Ks.DOLLY,RIGHT:Ks.PAN},this.touches={ONE:Js.ROTATE,TWO:Js.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new ui,this._lastTargetPosition=new V,this._quat=new ui().setFromUnitVectors(t.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new bo,this._sphericalDelta=new bo,this._scale=1,this._panOffset=new V,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new V,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=OA.bind(this),this._onPointerDown=DA.bind(this),this._onPointerUp=UA.bind(this),this._onContextMenu=HA.bind(this),this._onMouseWheel=BA.bind(this),this._onKeyDown=zA.bind(this),this._onTouchStart=VA.bind(this),this._onTouchMove=GA.bind(this),this._onMouseDown=kA.bind(this),this._onMouseMove=FA.bind(this),this._interceptControlDown=WA.bind(this),this._interceptControlUp=$A.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ae.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(d0),this.update(),this.state=Ae.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Mn.copy(e).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Ae.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(_u.origin.copy(this.object.position),_u.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(_u.direction))<NA?this.object.lookAt(this.target):(f0.setFromNormalAndCoplanarPoint(this.object.up,this.target),_u.intersectPlane(f0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>lf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>lf||this._lastTargetPosition.distanceToSquared(this.target)>lf?(this.dispatchEvent(d0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Mn.setFromMatrixColumn(e,0),Mn.multiplyScalar(-t),this._panOffset.add(Mn)}_panUp(t,e){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(e,1):(Mn.setFromMatrixColumn(e,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(t),this._panOffset.add(Mn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function DA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function OA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function UA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(p0),this.state=Ae.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function kA(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ks.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ae.DOLLY;break;case Ks.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ae.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ae.ROTATE}break;case Ks.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ae.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ae.PAN}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(cf)}function FA(n){switch(this.state){case Ae.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ae.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ae.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function BA(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ae.NONE||(n.preventDefault(),this.dispatchEvent(cf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(p0))}function zA(n){this.enabled!==!1&&this._handleKeyDown(n)}function VA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Js.ROTATE:if(this.enableRotate===!1){this.state=Ae.NONE;break}this._handleTouchStartRotate(n),this.state=Ae.TOUCH_ROTATE;break;case Js.PAN:if(this.enablePan===!1){this.state=Ae.NONE;break}this._handleTouchStartPan(n),this.state=Ae.TOUCH_PAN;break;default:this.state=Ae.NONE}break;case 2:switch(this.touches.TWO){case Js.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ae.TOUCH_DOLLY_PAN;break;case Js.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ae.TOUCH_DOLLY_ROTATE;break;default:this.state=Ae.NONE}break;default:this.state=Ae.NONE}this.state!==Ae.NONE&&this.dispatchEvent(cf)}function GA(n){switch(this._trackPointer(n),this.state){case Ae.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ae.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ae.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ae.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ae.NONE}}function HA(n){this.enabled!==!1&&n.preventDefault()}function WA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function $A(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var uf=120,m0=2,g0=6;function hf(n,t,e){let i=new WeakMap,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:uf+1},(u,h)=>e.timeAt(h/uf));i.set(l,c.map(u=>t.map(h=>n[h].pointsAt(e.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===e.span)return r;let h=o().map(d=>XA(d,l,c,s));return r={key:u,span:e.span,rows:qA(h),whole:x0(h)},r}return function(c,u,h,d){let f=new V().crossVectors(u,c).normalize(),p=[f,new V().crossVectors(c,f),c],{rows:x,whole:g}=a(p,h),m=d?YA(x,e.wayAt(e.time)*uf):g,[_,b,v,E,A,y]=m,M=[(_-b)/2,(v-E)/2,(A-y)/2],I=Math.max((_+b)/(2*h[0]),(v+E)/(2*h[1])),L=new V;for(let[C,D]of p.entries())L.addScaledVector(D,M[C]);return{target:L,distance:I-M[2]||1}}}function XA(n,t,e,i){let s=new Float64Array(g0).fill(-1/0),r=e.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,x]=[u(a,h,d),u(l,h,d),u(c,h,d)],[g,m]=[e[0]*x,e[1]*x],_=[f+g,g-f,p+m,m-p,x,-x];for(let b=0;b<g0;b++)_[b]>s[b]&&(s[b]=_[b])}return s.map((h,d)=>h+o[d])}function x0(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function qA(n){let t=(i,s)=>i.slice(Math.max(0,s-m0),s+m0+1),e=n.map((i,s)=>x0(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function YA(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var _0=28,ZA=1.05,y0=Math.PI/24,KA=1.15,Ir=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function v0(n,t,e,i,s=ir()){let{size:r,target:o}=JA(t),a=t.map((E,A)=>A),l=hf(t,a,e),c=a.map(E=>hf(t,[E],e)),u=new Yn(_0,1,.02*r,60*r);u.up.set(0,0,1);let h=new yu(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(E=0){let A=s.oneScale?l:c[E],y=Math.tan(_0*Math.PI/360)/ZA;d=A(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let E=u.position.clone().sub(h.target);s.closer=E.length()/d.distance,s.towards.copy(E).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let x=E=>{document.activeElement!==n&&!E.ctrlKey&&E.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",x,{capture:!0});function g({towards:E}){s.towards.set(...E).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function m(E,A){let y=s.towards.clone().applyAxisAngle(u.up,E*y0),M=new V().crossVectors(u.up,y).normalize(),I=y.clone().applyAxisAngle(M,-A*y0);s.towards.copy(Math.abs(I.z)<.9999?I:y),p()}function _(E){let A=s.closer*d.distance*KA**-E;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,A))/d.distance,p()}function b(E){Object.assign(s,E),p()}function v(E,A){u.aspect=E,u.updateProjectionMatrix(),h.rotateSpeed=A,h.panSpeed=A,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:g,turn:m,zoom:_,choose:b,resize:v,dispose:()=>h.dispose()}}function ir(){return{towards:new V(...Ir[0].towards).normalize(),closer:1,aside:new V,following:!0,oneScale:!0,scale:1}}function JA(n){let t=new V(1/0,1/0,1/0),e=new V(-1/0,-1/0,-1/0),i=new V;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}function Lo(n,t,{clientWidth:e,clientHeight:i}){let{x:s,y:r}=n.project(t);return[(s+1)/2*e,(1-r)/2*i]}var Za=1/0,df=1e-4;function b0(n,t,e){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:t.units.length)*Qp(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=e,a=e,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let u=(p,x)=>p!==Za?n.pointsAt(p,x):x?(x.set(o.points),x):o.points,h={...n,marks:[],efforts:null,stressed:!1,reach:n.mesh.base.radius,pointsAt:u,verticesAt:(p,x)=>p===Za?n.verticesOf(o.points,x):n.verticesAt(p,x),valuesAt(p,x,g){if(x!==Za)return n.valuesAt(p,x,g);let m=n.readings.findIndex(b=>b.name===p),_=p===Ts?o.energies_J:o.readings[m].map(b=>s[m]*b);return g?(g.set(_),g):Float32Array.from(_)},restLengthsAt(p,x){p===Za?x.set(o.restLengths_m):n.restLengthsAt(p,x)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,x=Za)=>x,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!jA(p,a,df*h.reach))&&(a=p,c())}return{clip:h,clock:d,show:f,get frame(){return o}}}function jA(n,t,e){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,t.points,e)||n.readings.some((s,r)=>i(s,t.readings[r],df*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,t.energies_J,df*Math.max(...t.energies_J))||i(n.restLengths_m,t.restLengths_m,0)}var QA=16,tE=6;function S0(n,t,e){let{lines:i}=t.creases,[s,r]=[n.canvas,n.cells[0]],o=S("p",{className:"crease-label","aria-hidden":"true",hidden:!0}),a=S("span",{className:"crease-mark","aria-hidden":"true",hidden:!0});r.append(a,o);let l=S("select",{},S("option",{value:""},"none"),...i.map(({name:y},M)=>S("option",{value:String(M)},y))),c=S("output",{"aria-live":"off"}),u=S("span",{},"or point at one in the picture, or touch it"),h=new V,d=null,f=null,p=null;function x(y){return Lo(h.fromArray(n.views[0].shape.vertices,3*y),n.eye.camera,r)}function g(y){let M=s.getBoundingClientRect(),I=[y.clientX-M.left,y.clientY-M.top],[L,C]=[null,QA];for(let[D,{ends:k}]of i.entries()){let N=eE(I,...k.map(x))+m(k);N<C&&([L,C]=[D,N])}return L}let m=y=>h.fromArray(_(y)).distanceTo(n.eye.camera.position)/(1e3*n.eye.size);function _(y){let{vertices:M}=n.views[0].shape;return[0,1,2].map(I=>(M[3*y[0]+I]+M[3*y[1]+I])/2)}function b(y){let{lines:M,columns:I}=t.creases,L=t.valuesAt(af,e.clipTime(0));return M[y].columns.map(C=>{let{name:D,unit:k}=I[C],N=k==="°"?`${On(L[C],1)}°`:`${be(Number(L[C].toPrecision(3)))} ${k}`;return`${D} ${N}`}).join(", ")}function v(){let y=f??d;if(o.hidden=a.hidden=y===null,c.textContent=d===null?"":b(d),u.hidden=d!==null,y===null)return;o.textContent=`${i[y].name}: ${b(y)}`;let[M,I]=i[y].ends.map(x),L=Math.hypot(I[0]-M[0],I[1]-M[1]),C=Math.atan2(I[1]-M[1],I[0]-M[0]);a.style.width=`${L.toFixed(1)}px`,a.style.transform=`translate(${M[0].toFixed(1)}px, ${M[1].toFixed(1)}px) rotate(${C.toFixed(4)}rad)`}let E=y=>{y!==f&&(f=y,v())},A=y=>{d=y,l.value=y===null?"":String(y),v()};return s.addEventListener("pointermove",y=>{y.pointerType==="mouse"&&E(y.buttons?null:g(y))}),s.addEventListener("pointerleave",()=>E(null)),s.addEventListener("pointerdown",y=>{p=y.isPrimary?[y.clientX,y.clientY]:null}),s.addEventListener("pointerup",y=>{if(!p||Math.hypot(y.clientX-p[0],y.clientY-p[1])>tE)return;let M=g(y);A(M===d?null:M)}),l.addEventListener("change",()=>A(l.value===""?null:Number(l.value))),n.onDraw(v),S("div",{className:"crease-choice"},S("label",{},`${t.creases.kind} `,l),c,u)}function eE([n,t],[e,i],[s,r]){let[o,a]=[s-e,r-i],l=Math.min(1,Math.max(0,((n-e)*o+(t-i)*a)/(o*o+a*a||1)));return Math.hypot(n-e-l*o,t-i-l*a)}var nE=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],iE="shift with ← → ↑ ↓",sE=[["+ −","nearer, further"],["0","reset the view"]];function vu(n,t){let i=(n.length===1?n[0].marks:[]).map((r,o)=>[String(o+1),r.name]),s=[...nE,...i,[iE,`turn the ${t}`],...sE].map(([r,o])=>S("tr",{},S("th",{scope:"row"},r),S("td",{},o)));return S("details",{className:"keys"},S("summary",{},"Keys"),S("table",{},S("tbody",{},...s)),S("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var M0={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function w0({key:n,shiftKey:t},e,i,s){if(t&&n in M0)e.turn(...M0[n]);else if(s)if(n==="+"||n==="=")e.zoom(1);else if(n==="-"||n==="−")e.zoom(-1);else if(n==="0")e.show(i);else return!1;else return!1;return!0}function A0(n,t,e){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&w0(i,t,e,!0)&&i.preventDefault()})}function bu(n,t,e,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){e.pause(),c()}function a(c,u){let{key:h}=c;if(w0(c,i,s,u))return!0;if(h in r)o(()=>e.step(r[h]));else if(h===" ")e.playing?e.pause():e.play();else if(h==="Home")o(()=>e.seek(e.span.start));else if(h==="End")o(()=>e.seek(e.span.end));else if(u)if(t.length===1&&t[0].marks[Number(h)-1])o(()=>e.seekClip(0,t[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var E0=2.4;function Ka(n){let t=10**Math.floor(Math.log10(n/E0));return t*[5,2,1].find(e=>e*t<=n/E0)}function T0(n,t){let e=Ka(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new vn().setAttribute("position",new sn(s,3)),l=new br(a,new Xs({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function ff(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[],r=n.find(({sample:a})=>a==="table"),o=r?`grid on the ${r.text}`:"grid";return S("ul",{className:"legend"},...n.filter(({sample:a})=>a!=="table").map(({sample:a,text:l})=>a==="tendon"?oE(l,t):rE(a,l)),...n.some(({sample:a})=>a==="tendon")?[S("li",{},"slack tendons sag, drawn with their rest length")]:[],S("li",{},`squares of the ${o}: ${Fs(Ka(e),"m")}`),...s.map(a=>S("li",{},a)))}function rE(n,t){let[e,i]=n.split(" "),s={mountain:{color:pu},valley:{color:mu},region:{background:Ya(i)}};return S("li",{className:e==="region"?"of-region":""},R0(e==="region"?"panel":e,s[e]??{}),t)}function oE(n,t){return pf(n,"0",Po,`${be(t.factor*t.largest_J)} ${t.unit}${t.orMore?" or more":""}`)}function pf(n,t,e,i){let s=R0("bar",{background:e.gradient});return S("li",{className:"energy"},`${n}: `,S("span",{className:"whole"},t,s,i))}function C0(n){let t=S("span"),e=document.createElement("canvas").getContext("2d");e.font="14px system-ui, sans-serif";let i=new Map([...new Set(n)].map(o=>[o,e.measureText(o).width])),s=[...i.keys()].reduce((o,a)=>i.get(a)>i.get(o)?a:o),r=S("span",{className:"room","aria-hidden":"true"},s);return{element:S("span",{className:"roomy"},r,t),say:o=>{t.textContent=o}}}function R0(n,t){let e=S("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function P0(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;aE(n,r)<t?e=r:i=r}return(e+i)/2}function aE(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function L0(n){let{triangles:t,faces:e,membraneLaw:i}=n.mesh,s=n.builtVertices(),r=Array.from({length:e.length},(h,d)=>I0(s,t,d)),o=new Float32Array(e.reduce((h,d)=>Math.max(h,d),0)+1),a=new Float32Array(e.length);function l(h,d){let{youngs_modulus_Pa:f,poisson_ratio:p}=i;return f/(1-p*p)*((1-p)*h+p*(h+d))}function c(h,d="strain"){o.fill(-1/0);for(let f=0;f<e.length;f++){let[p,x,g]=r[f],m=p*g-x*x;if(m<=1e-9*(p+g)**2)continue;let[_,b,v]=I0(h,t,f),E=(g*_-2*x*b+p*v)/(2*m),A=(_*v-b*b)/m,y=Math.sqrt(Math.max(E*E-A,0)),[M,I]=[(E+y-1)/2,(E-y-1)/2],L=d==="stress"?l(M,I):M;o[e[f]]=Math.max(o[e[f]],L)}for(let f=0;f<e.length;f++)a[f]=Math.max(0,o[e[f]]);return a}function u(h){let d=new Float32Array(s.length),f=0;for(let p of n.time)f=c(n.verticesAt(p,d),h).reduce((x,g)=>Math.max(x,g),f);return f}return{at:c,largest:u}}function I0(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var lE=.9,N0=.4,cE=.02,uE=["crease","rim","edge"],sr=12;function mf(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(I=>I.radius)),[o,a]=[!1,!0].map(I=>dE(e,I)),l=D0(e.tubes.filter(I=>I.kind==="bar"),20,0),c=D0(e.tubes.filter(I=>uE.includes(I.kind)),8,.4*r),u=fE(n,2.4*r),h=mE(e.base),d=n.efforts?u0(n):null,f=n.strained?L0(n):null,p=null,x=gE(e),g=new Ln;g.add(h.object,a.object,l.object,x.object,c.object,u.object,o.object),d&&g.add(d.group);let m=hE(o.object,a.object,l.object),_=[0,0,0],b=new $t;function v(I){n.verticesAt(I,i),o.pose(i),a.pose(i);for(let C of[l,c,x])C.pose(i);n.valuesAt(Ts,I,s);let L=s.map(C=>t>0?C/t:0);u.pose(i,I,C=>N0+(1-N0)*Math.min(1,Math.max(0,L[C])/cE));for(let C=0;C<n.tendons;C++)Po.at(L[C],_),u.colour(C,b.setRGB(..._,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(I),p&&E()}function E(){let I=f.at(i,p.quantity),L=[0,0,0];for(let C of[o,a])C.colour(D=>b.setRGB(...gu.at(I[D]/p.largest,L),"srgb"))}function A(I,L){p=f&&I?{quantity:I,largest:L}:null;for(let C of[o,a])C.flat(p!==null),p||C.colour(D=>b.set(Ya(e.regions[D])));p&&E()}function y(){for(let I of[l,c,x,h])I.paint();d?.paint(),m.children[0].material.color.set(me("--shadow"))}function M(){for(let I of[l,c,u,x])I.object.dispose();for(let I of[o,a])I.dispose();d?.dispose(),h.dispose();for(let I of[l,c,u,x])I.object.geometry.dispose(),I.object.material.dispose();m.children[0].material.dispose()}return{group:g,shadow:m,pose:v,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,colourSheets:A,dispose:M}}function hE(...n){let t=new bs({side:zn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:Pd,stencilZPass:Rd}),e=new Ln;for(let i of n){let s=i.isInstancedMesh?new di(i.geometry,t,i.count):new gn(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function dE(n,t){let e=n.regions.flatMap((v,E)=>n.solid[v]===t?[E]:[]),i=e.flatMap(v=>n.triangles.slice(3*v,3*v+3)),s=e.length,r=new an(new Float32Array(3*i.length),3).setUsage(Ha),o=new an(new Float32Array(3*i.length),3).setUsage(Ha),a=new an(new Uint32Array(i.length),1).setUsage(Ha);for(let v=0;v<i.length;v++)a.array[v]=v;let l=new vn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new Ms({vertexColors:!0,side:zn,flatShading:!0,transparent:!t,opacity:t?1:lE,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=v=>{v.fragmentShader=v.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new bs({vertexColors:!0,side:zn}),h=new gn(l,c);h.frustumCulled=!1,h.renderOrder=t?0:1;let d=new $t;f(v=>d.set(Ya(n.regions[v])));function f(v){for(let[E,A]of e.entries()){let y=v(A);for(let M=0;M<3;M++)y.toArray(o.array,9*E+3*M)}o.needsUpdate=!0}let p=v=>{h.material=v?u:c};function x(){l.dispose(),c.dispose(),u.dispose()}function g(v){for(let E=0;E<i.length;E++)for(let A=0;A<3;A++)r.array[3*E+A]=v[3*i[E]+A];r.needsUpdate=!0}let m=new Float32Array(s),_=Array.from({length:s},(v,E)=>E);function b(v){let E=r.array;for(let A=0;A<s;A++){let y=0;for(let M=0;M<3;M++){let I=9*A+M;y+=((E[I]+E[I+3]+E[I+6])/3-v.getComponent(M))**2}m[A]=y}_.sort((A,y)=>m[y]-m[A]);for(let A=0;A<s;A++)for(let y=0;y<3;y++)a.array[3*A+y]=3*_[A]+y;a.needsUpdate=!0}return{object:h,pose:g,sort:b,colour:f,flat:p,dispose:x}}function D0(n,t,e){let i=new di(new bi(1,1,1,t),Rr(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())Ro(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new $t(pu),V:new $t(mu),B:new $t(me("--bar"))};for(let[l,{crease:c,region:u}]of n.entries())i.setColorAt(l,u===void 0?a[c]:new $t(n0(u)));n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function fE(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new di(new bi(1,1,1,12),Rr(t),e.length*sr);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*(sr+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of e.entries()){pE(l,3*f[0],3*f[1],s[d],r);for(let x=0;x<sr;x++)Ro(r,3*x,3*x+3,u(d)*p,h,16*(d*sr+x))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<sr;u++)i.setColorAt(l*sr+u,c)}return{object:i,pose:o,colour:a}}function pE(n,t,e,i,s){let r=[0,1,2].map(d=>n[e+d]-n[t+d]),o=Math.hypot(...r),a=P0(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=sr;d++){let f=d/sr,p=4*a*f*(1-f)/h;for(let x=0;x<3;x++)s[3*d+x]=n[t+x]+f*r[x]+p*u[x]}}function mE({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=Rr(0),s=new di(new bi(1,1,1,16),i,n.length),r=new di(new yo(1,16,12),i,2*n.length),o=new Ln;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)Ro(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[t,e[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(me("--base")),dispose:a}}function gE(n){let t=new di(new yo(1,16,12),Rr(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(me("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var O0="system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";function Ja(n,t,e=1,[i,s]=[0,0]){n.save(),n.scale(e,e),n.translate(i,s);for(let r of t)U0(n,r);n.restore()}function U0(n,t){if(t.shapes){n.save(),t.kind==="moved"?n.translate(t.x,t.y):(n.beginPath(),n.rect(t.x,t.y,t.width,t.height),n.clip());for(let e of t.shapes)U0(n,e);n.restore();return}if(n.globalAlpha=t.opacity??1,n.setLineDash(t.dash??[]),n.lineWidth=t.lineWidth??1,t.kind==="text"){n.font=`${t.bold?"bold ":""}${t.size??12}px ${O0}`,n.textAlign={start:"left",middle:"center",end:"right"}[t.anchor??"start"],n.fillStyle=t.fill,n.fillText(t.text,t.x,t.y);return}if(n.beginPath(),t.kind==="rect"&&n.rect(t.x,t.y,t.width,t.height),t.kind==="circle"&&n.arc(t.x,t.y,t.r,0,2*Math.PI),t.kind==="path")for(let e of k0(t.points))for(let[i,s]of e.entries())n[i?"lineTo":"moveTo"](...s);(t.fill||t.scale)&&(n.fillStyle=t.scale?xE(n,t):t.fill,n.fill()),t.stroke&&(n.strokeStyle=t.stroke,n.stroke())}function xE(n,{x:t,width:e,scale:i}){let s=n.createLinearGradient(t,0,t+e,0);for(let[r,o]of i.entries())s.addColorStop(r/(i.length-1),o);return s}function k0(n){let t=[[]];for(let e of n)e?t.at(-1).push(e):t.at(-1).length&&t.push([]);return t.filter(e=>e.length)}function Mu(n,t,e,i){let s={count:0},r=[{kind:"rect",x:0,y:0,width:t,height:e,fill:"#ffffff"},...n].map(o=>Su(o,s));return[`<svg xmlns="http://www.w3.org/2000/svg" width="${Ue(t)}" height="${Ue(e)}" viewBox="0 0 ${Ue(t)} ${Ue(e)}" font-family="${O0}">`,`<title>${F0(i)}</title>`,...r,`</svg>
`].join(`
`)}function Su(n,t){if(n.kind==="svg")return`<svg ${`x="${Ue(n.x)}" y="${Ue(n.y)}" width="${Ue(n.width)}" height="${Ue(n.height)}"`} viewBox="${n.viewBox}"${n.stretched?' preserveAspectRatio="none"':""}>${n.content}</svg>`;if(n.scale){let h=`scale${++t.count}`,d=n.scale.map((f,p)=>`<stop offset="${Ue(p/(n.scale.length-1))}" stop-color="${f}"/>`);return`<linearGradient id="${h}">${d.join("")}</linearGradient>${Su({...n,scale:null,fill:`url(#${h})`},t)}`}if(n.kind==="moved")return`<g transform="translate(${Ue(n.x)} ${Ue(n.y)})">${n.shapes.map(h=>Su(h,t)).join(`
`)}</g>`;if(n.kind==="clip"){let h=`clip${++t.count}`;return`${`<clipPath id="${h}"><rect x="${Ue(n.x)}" y="${Ue(n.y)}" width="${Ue(n.width)}" height="${Ue(n.height)}"/></clipPath>`}<g clip-path="url(#${h})">${n.shapes.map(f=>Su(f,t)).join(`
`)}</g>`}let{fill:e="none",stroke:i,lineWidth:s=1,dash:r,opacity:o}=n,a=[`fill="${e}"`];i&&a.push(`stroke="${i}" stroke-width="${Ue(s)}" stroke-linejoin="round"`),r?.length&&a.push(`stroke-dasharray="${r.join(" ")}"`),o!==void 0&&o!==1&&a.push(`opacity="${o}"`);let{x:l,y:c}=n;return n.kind==="rect"?`<rect x="${Ue(l)}" y="${Ue(c)}" width="${Ue(n.width)}" height="${Ue(n.height)}" ${a.join(" ")}/>`:n.kind==="circle"?`<circle cx="${Ue(l)}" cy="${Ue(c)}" r="${Ue(n.r)}" ${a.join(" ")}/>`:n.kind==="path"?`<path d="${k0(n.points).map(d=>`M${d.map(f=>f.map(Ue).join(" ")).join("L")}`).join("")}" ${a.join(" ")}/>`:`<text ${n.turned?`transform="translate(${Ue(l)} ${Ue(c)}) rotate(-90)"`:`x="${Ue(l)}" y="${Ue(c)}"`} font-size="${n.size??12}"${n.bold?' font-weight="bold"':""} text-anchor="${n.anchor??"start"}" ${a.join(" ")}>${F0(n.text)}</text>`}var Ue=n=>String(Number(n.toFixed(2))),F0=n=>n.replace(/[&<>"]/g,t=>`&#${t.charCodeAt(0)};`);var wu=8,_E=["fill","stroke","stroke-width","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","font-size","font-weight","paint-order","text-anchor"],yE=new Set(["fill","stroke"]);function rr(n,t,e=null){for(let i of n)i.classList.add("paper");try{let i=n.map(c=>c.getBoundingClientRect()),[s,r]=[Math.min(...i.map(c=>c.left))-wu,Math.min(...i.map(c=>c.top))-wu],[o,a]=[Math.max(...i.map(c=>c.right))-s+wu,Math.max(...i.map(c=>c.bottom))-r+wu],l=n.flatMap(c=>xf(c,s,r,e));return{svg:Mu(l,o,a,t),width:o,height:a}}finally{for(let i of n)i.classList.remove("paper")}}function gf(n){n.classList.add("paper");try{let{left:t,top:e,width:i,height:s}=n.getBoundingClientRect();return{shapes:xf(n,t,e,null),width:i,height:s}}finally{n.classList.remove("paper")}}function xf(n,t,e,i){let s=getComputedStyle(n);if(s.display==="none"||s.visibility==="hidden"||i&&n.matches(i))return[];let r=n.getBoundingClientRect(),o={x:r.left-t,y:r.top-e,width:r.width,height:r.height};if(n.localName==="svg")return[{kind:"svg",...o,viewBox:n.getAttribute("viewBox"),stretched:n.getAttribute("preserveAspectRatio")==="none",content:ME(n)}];let a=[];r.width&&r.height&&a.push(...vE(s,o)),a.push(...bE(s,o));for(let l of n.childNodes)l.nodeType===Node.TEXT_NODE?a.push(...SE(l,s,t,e)):l.nodeType===Node.ELEMENT_NODE&&a.push(...xf(l,t,e,i));return a}function vE(n,t){let e=ja(n.backgroundColor),i=n.borderTopLeftRadius==="50%"&&t.width===t.height,s=[];e.opacity>0&&!i&&s.push({kind:"rect",...t,fill:e.text,opacity:e.opacity});let r=/^linear-gradient\(to right, (.*)\)$/.exec(n.backgroundImage);return r&&s.push({kind:"rect",...t,scale:r[1].match(/rgb\([^)]*\)/g)}),i&&s.push({kind:"circle",x:t.x+t.width/2,y:t.y+t.height/2,r:t.width/2-1,stroke:ja(n.borderTopColor).text,lineWidth:parseFloat(n.borderTopWidth),...e.opacity?{fill:e.text}:{}}),s}function bE(n,{x:t,y:e,width:i,height:s}){if(n.borderTopLeftRadius==="50%")return[];let r={Top:[[t,e],[t+i,e]],Right:[[t+i,e],[t+i,e+s]],Bottom:[[t,e+s],[t+i,e+s]],Left:[[t,e],[t,e+s]]};return Object.entries(r).flatMap(([o,a])=>{let[l,c]=[n[`border${o}Style`],parseFloat(n[`border${o}Width`])];if(l==="none"||!c)return[];let u=ja(n[`border${o}Color`]);return u.opacity?[{kind:"path",points:a,stroke:u.text,lineWidth:c,opacity:u.opacity,...l==="dashed"?{dash:[2*c,c]}:{}}]:[]})}function SE(n,t,e,i){let s=parseFloat(t.fontSize),r={size:s,bold:Number(t.fontWeight)>=600,fill:ja(t.color).text},o=document.createRange(),a=[];for(let{index:l,0:c}of n.data.matchAll(/\S+/g)){o.setStart(n,l),o.setEnd(n,l+c.length);let[u]=o.getClientRects();if(!u)continue;let h=a.at(-1),d=t.writingMode==="horizontal-tb";h&&Math.abs(d?h.box.top-u.top:h.box.left-u.left)<2?(h.words.push(c),h.last=u):a.push({words:[c],box:u,last:u})}return t.writingMode==="horizontal-tb"?a.map(({words:l,box:c})=>({kind:"text",x:c.left-e,y:c.top-i+c.height/2+.35*s,text:l.join(" "),...r})):a.map(({words:l,box:c,last:u})=>({kind:"text",x:(c.left+c.right)/2-e+.35*s,y:(Math.min(c.top,u.top)+Math.max(c.bottom,u.bottom))/2-i,text:l.join(" "),anchor:"middle",turned:!0,...r}))}function ME(n){let t=n.cloneNode(!0),[e,i]=[n,t].map(s=>[...s.querySelectorAll("*")]);for(let[s,r]of e.entries()){let o=getComputedStyle(r),a=i[s];for(let{name:l}of[...a.attributes])/^(aria-|data-|class$|role$|tabindex$|style$)/.test(l)&&a.removeAttribute(l);if(!(r.localName==="g"||r.localName==="title"))for(let l of _E){let c=o.getPropertyValue(l);if(!yE.has(l))a.setAttribute(l,c);else{let{text:u,opacity:h}=c==="none"?{text:"none",opacity:1}:ja(c);a.setAttribute(l,h?u:"none"),h&&h<1&&a.setAttribute(`${l}-opacity`,h)}}}return new XMLSerializer().serializeToString(t).replace(/^<svg[^>]*>|<\/svg>$/g,"")}function ja(n){let t=(n.match(/[\d.]+(?:e-?\d+)?%?/g)??[]).map(Number);return{text:`rgb(${(n.startsWith("color(")?t.slice(0,3).map(i=>255*i):t.slice(0,3)).map(Math.round).join(",")})`,opacity:t[3]??1}}function B0(n,t,e){let i=[];return{add:s=>i.push(wE(s)),bytes:()=>AE(i,n,t,Math.round(100*e))}}function wE(n){let t=new Uint16Array(n.length/4);for(let e=0;e<t.length;e++)t[e]=n[4*e]>>3<<10|n[4*e+1]>>3<<5|n[4*e+2]>>3;return t}function AE(n,t,e,i){let{palette:s,indexOf:r}=TE(n),o=[],a=c=>o.push(c&255,c>>8);o.push(...new TextEncoder().encode("GIF89a")),a(t),a(e),o.push(247,0,0,...s),o.push(33,255,11,...new TextEncoder().encode("NETSCAPE2.0"),3,1,0,0,0);let l=null;for(let c of n){let u=Uint8Array.from(c,(d,f)=>l&&l[f]===d?255:r[d]);o.push(33,249,4,5),a(i),o.push(255,0,44);for(let d of[0,0,t,e])a(d);o.push(0,8);let h=EE(u);for(let d=0;d<h.length;d+=255){let f=Math.min(d+255,h.length);o.push(f-d);for(let p=d;p<f;p++)o.push(h[p])}o.push(0),l=c}return o.push(59),Uint8Array.from(o)}function EE(n){let t=[],[e,i]=[0,0],s=9,r=258,o=new Int32Array(1048576).fill(-1),a=c=>{for(e|=c<<i,i+=s;i>=8;)t.push(e&255),e>>>=8,i-=8};a(256);let l=n[0];for(let c=1;c<n.length;c++){let u=l<<8|n[c];if(o[u]>=0){l=o[u];continue}a(l),r<4096?(o[u]=r,r===1<<s&&s<12&&s++,r++):(a(256),o.fill(-1),[s,r]=[9,258]),l=n[c]}return a(l),a(257),i&&t.push(e&255),t}function TE(n){let t=new Uint32Array(32768);for(let o of n)for(let a=0;a<o.length;a++)t[o[a]]++;let e=[...t.keys()].filter(o=>t[o]),i=[_f(e,t)];for(;i.length<255;){let o=i.reduce((c,u)=>u.spread>c.spread?u:c);if(!o.spread)break;let a=o.colours.sort((c,u)=>Au(c)[o.channel]-Au(u)[o.channel]),l=a.length>>1;i.splice(i.indexOf(o),1,_f(a.slice(0,l),t),_f(a.slice(l),t))}let s=new Uint8Array(3*256),r=new Uint8Array(32**3);for(let[o,{colours:a,weight:l}]of i.entries()){for(let c=0;c<3;c++){let u=a.reduce((h,d)=>h+t[d]*Au(d)[c],0)/l;s[3*o+c]=Math.round(u*255/31)}for(let c of a)r[c]=o}return{palette:s,indexOf:r}}var Au=n=>[n>>10,n>>5&31,n&31];function _f(n,t){let e=n.reduce((r,o)=>r+t[o],0),i=[0,1,2].map(r=>{let o=n.map(a=>Au(a)[r]);return o.reduce((a,l)=>Math.max(a,l))-o.reduce((a,l)=>Math.min(a,l))}),s=Math.max(...i);return{colours:n,weight:e,channel:i.indexOf(s),spread:s*s*Math.sqrt(e)}}var vf=8,z0=12.5,CE=25,RE=.6,[PE,V0,IE]=[640,1280,2400],yf=30,[No,LE,G0]=[10,210,24],NE=8,DE=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"];function Tu(n,t,e,i){let r=[us("PNG","download PNG of the picture",async()=>{let o=S("canvas");await W0(n,()=>n.drawSharp(IE,()=>Eu(o,n,e(),i(),n.canvas.width)));let a=await new Promise(l=>o.toBlob(l,"image/png"));gr(a,`${qn("picture")}.png`)})];if(t.seek&&t.timeAt){r.push(H0("GIF","gif",l=>UE(n,t,e,i,l)));let o=DE.find(l=>globalThis.MediaRecorder?.isTypeSupported(l)),a=o?.startsWith("video/mp4")?"MP4":"WebM";o&&HTMLCanvasElement.prototype.captureStream&&r.push(H0(a,a.toLowerCase(),l=>kE(n,t,e,i,l,o)))}return S("span",{className:"films",role:"group","aria-label":"save"},...r)}function H0(n,t,e){let i=null,s=us(n,`download a film as ${n}`,async()=>{if(i){i.stopped=!0;return}i={stopped:!1,progress:r=>{s.textContent=`${Math.round(100*r)} %`}};try{let r=await e(i);i.stopped||gr(r,`${qn("motion")}.${t}`)}finally{i=null,s.textContent=n}});return s}async function W0(n,t){let e=nf();n.paint();try{return await t()}finally{e(),n.paint()}}async function $0(n,t,e,i){let s=t.time;t.pause?.(),await W0(n,async()=>{for(let r=e();r!==null;r=e())t.seek(t.timeAt(Math.min(1,r))),await OE(),i(r)}),t.seek(s)}var OE=()=>new Promise(n=>requestAnimationFrame(n));async function UE(n,t,e,i,s){let r=S("canvas"),o=Math.round(vf*z0),[a,l]=[0,null];return await $0(n,t,()=>s.stopped||a>o?null:a/o,c=>{Eu(r,n,e(),i(),PE),l??=B0(r.width,r.height,1/z0),l.add(r.getContext("2d",{willReadFrequently:!0}).getImageData(0,0,r.width,r.height).data),s.progress(c),a++}),s.stopped?null:new Blob([l.bytes()],{type:"image/gif"})}async function kE(n,t,e,i,s,r){let o=S("canvas");Eu(o,n,e(),i(),V0);let a=new MediaRecorder(o.captureStream(CE),{mimeType:r,videoBitsPerSecond:8e6}),l=[];a.ondataavailable=({data:d})=>l.push(d);let c=new Promise(d=>{a.onstop=d});a.start();let u=performance.now(),h=()=>(performance.now()-u)/1e3;return await $0(n,t,()=>s.stopped||h()>vf+RE?null:h()/vf,d=>{Eu(o,n,e(),i(),V0),s.progress(Math.min(1,d))}),a.stop(),await c,new Blob(l,{type:r.split(";")[0]})}function Eu(n,t,e,i,s){let{canvas:r,cells:o}=t,a=s/r.clientWidth,l=Math.round(a*r.clientHeight),c=Math.max(1,a),u=FE(e,i,s/c),h=Math.round(c*u.height),d=[2*Math.round(s/2),2*Math.round((l+h)/2)];(n.width!==d[0]||n.height!==d[1])&&([n.width,n.height]=d);let f=n.getContext("2d",{willReadFrequently:!0});if(f.fillStyle="#ffffff",f.fillRect(0,0,...d),f.drawImage(r,0,0,s,l),o.length>1)for(let p of o)Ja(f,gf(p).shapes,a,[p.offsetLeft,p.offsetTop]);Ja(f,u.shapes,c,[0,l/c])}function FE(n,t,e){let i=[{kind:"text",x:No,y:20,text:n.text,bold:!0,size:14,fill:"#16191d"}],[s,r]=[n.longest?Math.max(LE,No+NE*n.longest+G0):No,0];for(let{shapes:o,width:a,height:l}of t.map(gf))s>No&&s+a>e-No&&([s,r]=[No,r+yf]),i.push({kind:"moved",x:s,y:r+(yf-l)/2,shapes:o}),s+=a+G0;return{shapes:i,height:r+yf}}var BE=[{quantity:null,name:"panels"},{quantity:"strain",name:"strain",text:"largest Green strain of the membrane",value:n=>`${be(100*n)} %`},{quantity:"stress",name:"stress",text:"largest stress of the membrane (second Piola-Kirchhoff)",value:(n,t)=>Fs(n,t)}];function bf(n,t,e){let i=S("li",{className:"energy",hidden:!0});t.append(i);let s=e.find(a=>a.stressed)?.mesh.membraneLaw.unit,o=BE.filter(({quantity:a})=>a!=="stress"||e.every(l=>l.stressed||!l.strained)).map(({quantity:a,name:l,text:c,value:u},h)=>{let d=S("button",{type:"button","aria-pressed":String(h===0)},l);return d.addEventListener("click",()=>{let f=n.colourSheets(a);a&&i.replaceChildren(...pf(c,"0",gu,u(f,s)).childNodes),i.hidden=!a;for(let p of t.querySelectorAll(".of-region"))p.hidden=!!a;for(let p of o)p.setAttribute("aria-pressed",String(p===d))}),d});return S("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",S("span",{},...o))}var zE=new V(0,1,0),Sf=[.86,.78],X0=.1,Mf=.004,q0=.035;function Y0(n){let t=new bs,e=new gn(new bi(Mf,Mf,X0,10),t),i=new gn(new Sr(3*Mf,q0,16),t);e.position.y=-q0/2,i.position.y=X0/2;let s=new Ln;s.add(e,i),s.quaternion.setFromUnitVectors(zE,new V(...n));let r=()=>t.color.set(me("--bar")),[o,a]=[new V,new V];function l(u,h){let d=o.copy(h).project(u).z;a.set(Sf[0],1,d).unproject(u),s.position.set(Sf[0],-1,d).unproject(u),s.scale.setScalar(a.distanceTo(s.position)),s.position.set(...Sf,d).unproject(u)}function c(){for(let u of[e,i])u.geometry.dispose();t.dispose()}return{group:s,paint:r,follow:l,dispose:c}}var Z0=2,VE=.84,Cu=1024,GE=Uint8Array.from({length:Cu+1},(n,t)=>{let e=t/Cu;return Math.round(255*(e<=.0031308?12.92*e:1.055*e**(1/2.4)-.055))}),wf=n=>GE[Math.min(Cu,Math.max(0,Math.round(Cu*n)))];function K0(n){let t=n.getContext("2d"),e=document.createElement("canvas"),i={frame:0,calls:0,triangles:0},s=1,r=[0,0,1,1];return{info:{render:i},setPixelRatio(o){s=o},setSize(o,a){[n.width,n.height]=[Math.floor(o*s),Math.floor(a*s)]},setScissorTest(){},setScissor(){},setViewport(...o){r=o.map(a=>a*s)},clear(){i.frame+=1,t.clearRect(0,0,n.width,n.height)},render(o,a){let[l,c]=[Math.round(r[2]*Z0),Math.round(r[3]*Z0)];if(l<1||c<1)return;let u=HE(o,a,l,c);[e.width,e.height]=[l,c],e.getContext("2d").putImageData(u,0,0),t.drawImage(e,r[0],n.height-r[1]-r[3],r[2],r[3])},dispose(){},forceContextLoss(){}}}function HE(n,t,e,i){let s=new ImageData(e,i),r={width:e,height:i,colours:new Uint32Array(s.data.buffer),depths:new Float32Array(e*i).fill(1/0)};n.updateMatrixWorld(),t.updateMatrixWorld();let o=WE(n),a=new ae().multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),l=[];n.traverseVisible(u=>{u.geometry&&!Af(u)[0].stencilWrite&&l.push(u)});for(let u of l.filter(h=>h.isLineSegments))ZE(u,a,r);let c={projection:a,view:t.matrixWorldInverse,perspective:t.projectionMatrix,position:t.position};for(let u of l.filter(h=>h.isMesh))XE(u,c,o,r);return s}var Af=({material:n})=>Array.isArray(n)?n:[n];function WE(n){let t={towards:new V(0,0,1),sun:new $t(0),sky:new $t(0),ground:new $t(0)};return n.traverse(e=>{e.isDirectionalLight&&(t.towards.copy(e.position).normalize(),t.sun.copy(e.color).multiplyScalar(e.intensity/Math.PI)),e.isHemisphereLight&&(t.sky.copy(e.color).multiplyScalar(e.intensity/Math.PI),t.ground.copy(e.groundColor).multiplyScalar(e.intensity/Math.PI))}),t}function $E(n,t,e,i,s){if(e.isMeshBasicMaterial){for(let h=0;h<3;h++)s[h]=wf(t[h]);return}let r=Math.max(0,n.dot(i.towards)),o=.5*n.y+.5,a=e.emissive&&e.emissiveIntensity?e.emissive.toArray().map(h=>h*e.emissiveIntensity):null,[l,c,u]=[i.sun,i.sky,i.ground].map(h=>[h.r,h.g,h.b]);for(let h=0;h<3;h++)s[h]=wf(t[h]*(r*l[h]+o*c[h]+(1-o)*u[h])+(a?.[h]??0))}function XE(n,t,e,i){let{geometry:s}=n,r=Af(n),o={start:0,count:s.index?.count??s.attributes.position.count,materialIndex:0},a=Array.isArray(n.material)?s.groups:[o],l=n.isInstancedMesh?n.count:1,[c,u,h]=[new ae,new ae,new $t];for(let d=0;d<l;d++){c.copy(n.matrixWorld),h.set(1,1,1),n.isInstancedMesh&&(n.getMatrixAt(d,u),c.multiply(u),n.instanceColor&&n.getColorAt(d,h));for(let f of a)qE(s,f,c,r[f.materialIndex],h,t,e,i)}}function qE(n,{start:t,count:e},i,s,r,o,a,l){let{position:c,normal:u,color:h}=n.attributes,d=u&&!s.flatShading,f=[s.color.r*r.r,s.color.g*r.g,s.color.b*r.b],p=new te().getNormalMatrix(i),x=s.userData.nearer??0,g=new Map,m=new Fe,_=new V;function b(L){if(g.has(L))return g.get(L);_.fromBufferAttribute(c,L).applyMatrix4(i);let C=_.clone();m.set(_.x,_.y,_.z,1).applyMatrix4(o.projection);let D={place:C,x:(m.x/m.w+1)/2*l.width,y:(1-m.y/m.w)/2*l.height,depth:m.z/m.w,behind:m.w<=0,normal:d?new V().fromBufferAttribute(u,L).applyMatrix3(p).normalize():null};return x&&(_.applyMatrix4(o.view),_.addScaledVector(_.clone().normalize(),-x),m.set(_.x,_.y,_.z,1).applyMatrix4(o.perspective),D.depth=m.z/m.w),g.set(L,D),D}let[v,E,A,y]=[new V,new V,new V,new V],M=[0,0,0],I=[[0,0,0],[0,0,0],[0,0,0]];for(let L=t;L+2<t+e;L+=3){let C=[0,1,2].map(N=>n.index?n.index.getX(L+N):L+N),D=C.map(b);if(D.some(N=>N.behind))continue;v.subVectors(D[1].place,D[0].place),E.subVectors(D[2].place,D[0].place),A.crossVectors(v,E).normalize(),y.subVectors(o.position,D[0].place);let k=A.dot(y)<0;k&&A.negate();for(let N=0;N<3;N++){let B=C[N];for(let W=0;W<3;W++)M[W]=f[W]*(h?h.getComponent(B,W):1)*(k&&h&&!s.isMeshBasicMaterial?VE:1);$E(d?D[N].normal:A,M,s,a,I[N])}YE(D,I,l)}}function YE([n,t,e],i,{width:s,height:r,colours:o,depths:a}){let l=(t.x-n.x)*(e.y-n.y)-(t.y-n.y)*(e.x-n.x);if(Math.abs(l)<1e-9)return;let[c,u]=[Math.max(0,Math.floor(Math.min(n.x,t.x,e.x))),Math.min(s-1,Math.ceil(Math.max(n.x,t.x,e.x)))],[h,d]=[Math.max(0,Math.floor(Math.min(n.y,t.y,e.y))),Math.min(r-1,Math.ceil(Math.max(n.y,t.y,e.y)))],[f,p,x]=i,g=f.every((v,E)=>v===p[E]&&v===x[E]),m=4278190080|f[2]<<16|f[1]<<8|f[0],[_,b]=[(e.y-n.y)/l,(n.y-t.y)/l];for(let v=h;v<=d;v++){let[E,A]=[c+.5-n.x,v+.5-n.y],y=(E*(e.y-n.y)-A*(e.x-n.x))/l,M=(A*(t.x-n.x)-E*(t.y-n.y))/l,I=v*s+c;for(let L=c;L<=u;L++,I++,y+=_,M+=b){let C=1-y-M;if(C<0||y<0||M<0)continue;let D=C*n.depth+y*t.depth+M*e.depth;D>=a[I]||(a[I]=D,o[I]=g?m:4278190080|C*f[2]+y*p[2]+M*x[2]<<16|C*f[1]+y*p[1]+M*x[1]<<8|C*f[0]+y*p[0]+M*x[0])}}}function ZE(n,t,{width:e,height:i,colours:s}){let{position:r}=n.geometry.attributes,[o]=Af(n),[a,l,c]=[o.color.r,o.color.g,o.color.b].map(wf),u=Math.round(255*o.opacity)<<24|c<<16|l<<8|a,h=[0,1].map(()=>new Fe);for(let d=0;d+1<r.count;d+=2){for(let[g,m]of h.entries())m.set(r.getX(d+g),r.getY(d+g),r.getZ(d+g),1).applyMatrix4(n.matrixWorld).applyMatrix4(t);if(h.some(g=>g.w<=0))continue;let[f,p]=h.map(g=>[(g.x/g.w+1)/2*e,(1-g.y/g.w)/2*i]),x=Math.min(2e4,Math.ceil(Math.max(Math.abs(p[0]-f[0]),Math.abs(p[1]-f[1]))));for(let g=0;g<=x;g++){let[m,_]=[0,1].map(b=>Math.floor(f[b]+g/(x||1)*(p[b]-f[b])));m>=0&&m<e&&_>=0&&_<i&&(s[_*e+m]=u)}}}var J0=4096,KE=3.2,JE=new V(-.45,.75,1),jE=.42*Math.PI,QE=.64*Math.PI,tT=.5,eT=.14;function Qa(n,t,e,i,s){let r=S("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${iT}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0}),a=n.map(()=>S("div",{className:"cell"})),l=n.length>1,c=S("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(KE*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=o?new hu({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0}):K0(r);h.setScissorTest(!0);let d=v0(r,n,t,m,s),f=n.map(k=>sT(k,e(k),d)),p=0,x=!1,g=new Set;function m(){p||(p=requestAnimationFrame(b))}function _(){for(let[k,N]of f.entries())N.shape.pose(t.clipTime(k));x=!0}function b(){cancelAnimationFrame(p),p=0,x||_();let k=r.clientHeight,N=u();h.setScissor(0,0,r.clientWidth,k),h.setViewport(0,0,r.clientWidth,k),h.clear();for(let[B,W]of f.entries()){d.aim(B);let H=a[B],st=[H.offsetLeft,k-H.offsetTop-H.offsetHeight,H.offsetWidth,H.offsetHeight-N];h.setViewport(...st),h.setScissor(...st),W.light.position.copy(JE).applyQuaternion(d.camera.quaternion);let Y=d.camera.position.z>W.floor.position.z;W.floor.material.opacity=Y?tT:eT,W.shape.shadow.visible=Y,W.shape.sort(d.camera.position),W.gravity?.follow(d.camera,d.controls.target),h.render(W.scene,d.camera)}d.aim();for(let B of g)B()}function v(){for(let k of f)k.floor.material.color.set(me("--floor")),k.shape.paint(),k.gravity?.paint();m()}function E(){let[k,N]=[c.clientWidth,c.clientHeight];if(!k||!N)return;h.setPixelRatio(Math.min(devicePixelRatio,2,J0/Math.max(k,N))),h.setSize(k,N,!1);let B=a[0].offsetHeight-u();d.resize(a[0].offsetWidth/B,N/B),b()}function A(k,N){let B=Math.min(k/c.clientWidth,J0/Math.max(c.clientWidth,c.clientHeight));h.setPixelRatio(B),h.setSize(c.clientWidth,c.clientHeight,!1),b();let W=N();return E(),W}let y=new ResizeObserver(E);y.observe(c);let M=t.onChange(()=>{x=!1,b()}),I=tr(v);r.addEventListener("webglcontextrestored",m),v();function L(){cancelAnimationFrame(p),M(),I(),y.disconnect(),d.dispose();for(let{shape:k,floor:N,gravity:B}of f)k.dispose(),B?.dispose(),N.geometry.dispose(),N.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function C(k){let N=k?f.reduce((B,{shape:W})=>Math.max(B,W.strains?.largest(k)??0),0):0;for(let{shape:B}of f)B.colourSheets?.(k,N||Number.MIN_VALUE);return m(),N}let D=o?null:S("p",{className:"note"},nT);return{element:c,note:D,canvas:r,cells:a,eye:d,pose:_,draw:b,drawSharp:A,paint:v,views:f,colourSheets:C,onDraw:k=>g.add(k),statistics:()=>h.info.render,dispose:L}}var nT="This browser has no WebGL: the processor draws the picture, without shadows and more slowly.",iT="Drag to turn, pinch to zoom; keys are listed below.";function sT(n,t,e){let i=T0(e.size,e.target);i.position.z=n.mesh.table_m??rT(n)-.06*e.size,t.shadow.position.z=i.position.z+.001*e.size;let s=new Na("#ffffff",jE),r=new ya;r.add(t.group,t.shadow,i,s,new Pa("#ffffff","#dde2e8",QE));let o=n.mesh.gravity&&Y0(n.mesh.gravity);return o&&r.add(o.group),{shape:t,floor:i,light:s,scene:r,gravity:o}}function rT(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var oT=.3,aT=4,lT=4,j0=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function Q0(n,t){let e=cT(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())uT(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?oT:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:t.seconds??aT+lT*a,wayAt:l=>nr(e,i,l),timeAt:l=>nr(i,e,l)}}function cT(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function uT(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}var hT="M7 4.5v15l12-7.5z",dT="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Ef=1e4,fT=.02;function Ru(n,t){let e=S("button",{type:"button",className:"play"}),i=S("input",{type:"range",min:0,max:Ef,step:1,"aria-label":t.span.unit?t.span.name:"time"}),s=S("div",{className:"bands","aria-hidden":"true"}),r=S("div",{className:"ticks","aria-hidden":"true"}),o=S("p",{className:n[0].along.length?"time long":"time"}),a=S("p",{className:"spoken",role:"status"}),l=S("div",{className:"states"}),c=null,u=[];function h(){n.length>1||n[0].marks===c||(c=n[0].marks,u=c.map(g=>mT(g,t)),l.replaceChildren(...u))}h();let d=S("div",{className:"transport"},S("div",{className:"line"},e,S("div",{className:"tracks"},...pT(n[0],t),S("div",{className:"track"},s,i,r))),S("div",{className:"choices"},o,l,...t.span.unit?[]:[gT(t)],...xT(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/Ef))});let f={},p=null,x=0;return t.onChange(()=>{h();let{span:g,stretched:m}=t;(g!==f.span||m!==f.stretched)&&_T(n,t,s,r),f={span:g,stretched:m},i.value=Math.round(Ef*t.shareAt(t.time)),i.setAttribute("aria-valuetext",tx(n,t));let _=n.length===1?tl(n[0],t.clipTime(0)):"",b=n.length===1?_&&` · ${_}`:t.span.label.replace("time",""),v=t.playing&&!t.span.unit?`, ${yT(t.slowness)}`:"";o.textContent=`${Yi(t.time,t.span)}${b}${v}${ex(n[0],t.clipTime(0)," · ")}`;for(let[E,A]of(c??[]).entries())u[E].setAttribute("aria-pressed",String(Math.abs(A.time-t.clipTime(0))<1e-9));t.playing!==p&&(e.replaceChildren(ml(t.playing?dT:hT)),e.setAttribute("aria-label",t.playing?"pause":"play"),p=t.playing),clearTimeout(x),t.playing||(x=setTimeout(()=>{a.textContent=tx(n,t)},600))}),d}function pT(n,t){if(!n.along.length)return[];let e=Ih("",100),i=S("span",{className:"profile-ball"}),s=S("small"),r=c=>100*t.shareAt(c),o=null,a=null;function l(c){let u=n.line(c.key,0),[h,d]=[Math.min(0,...u),Math.max(...u)];o=p=>100-100*(p-h)/(d-h||1);let f=Array.from(u,(p,x)=>`${r(n.time[x]).toFixed(2)} ${o(p).toFixed(2)}`);e.querySelector("path").setAttribute("d",`M${f.join("L")}`),s.textContent=c.name,s.classList.toggle("at-start",u[0]<u.at(-1)),a=c}return t.onChange(()=>{let[c]=n.along;c!==a&&l(c);let u=t.clipTime(0);i.style.left=`${r(u).toFixed(2)}%`,i.style.top=`${o(n.valuesAt(c.key,u)[0]).toFixed(2)}%`}),[S("div",{className:"profile","aria-hidden":"true"},e,i,s)]}function mT(n,t){let e=S("button",{type:"button",className:"state"},S("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function gT(n){let t=j0.map(({name:i,value:s})=>S("option",{value:String(s)},i)),e=S("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),S("label",{},"speed ",e)}function xT(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>S("option",{value:String(s)},i.name)),e=S("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[S("label",{},"show ",e)]}function _T(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=S("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&e.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let[h,d]=[r(u),i.lastElementChild];if(d&&n.length===1&&h-d.at<fT){d.append(` ${c.letter}`);continue}let f=S("span",{className:"tick",at:h},n.length===1?c.letter:"");f.style.left=`${100*h}%`,n.length>1&&f.style.setProperty("--tick",`var(--line-${o%7})`),i.append(f)}}}function yT(n){return n<1.05?"real time":`${n<10?On(n,1):Math.round(n)} times slower`}function tl(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function ex(n,t,e){let i=({name:s,unit:r,key:o})=>`${e}${s} ${be(Number(n.valuesAt(o,t)[0].toPrecision(3)))} ${r}`;return n.along.map(i).join("")}function tx(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${tl(i,r)||t.span.name}${ex(i,r,", ")}${vT(i,r)}`});return`${Yi(t.time,t.span)}: ${e.join("; ")}`}function vT(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>On(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function or(n,t,e,{energy:i,legend:s,text:r,whole:o},a,l=t.length>1||!!a){let c=Qa(t,e,x=>mf(x,i.largest_J),r,a),u=S("div",{className:"picture"},c.element,...c.note?[c.note]:[],Iu(c.eye,l?o:null));t.length===1&&ST(c.cells[0],t[0],e);let h=[ff(s,i,c.eye.size,t.length>1?o:null)];t.some(x=>x.strained)&&h.unshift(bf(c,h[0],t)),t.length===1&&t[0].efforts?.drives.length&&MT(h.at(-1),t[0],e),t.length>1&&t.some(x=>x.efforts?.drives.some(g=>g.arrow))&&h.at(-1).append(S("li",{className:"effort"},ix(),"torque or force of a drive, while it acts"));let d=t.length===1&&t[0].creases?[S0(c,t[0],e)]:[];n.replaceChildren(u,Ru(t,e),...d,...h,vu(t,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`),nx(n,c,e,()=>bT(t,e));let f=bu(n,t,e,c.eye,Ir[0]);function p(){e.pause(),f(),c.dispose(),n.replaceChildren()}return{stage:c,dispose:p}}function Pu(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Qa(t,e,h=>mf(h,i.largest_J),r,a),c=S("div",{className:"picture"},l.element,...l.note?[l.note]:[],Iu(l.eye,null,!a)),u=[ff(s,{...i,orMore:!0},l.eye.size,null)];return t.some(h=>h.strained)&&u.unshift(bf(l,u[0],t)),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),nx(n,l,e,()=>({text:"",longest:0})),A0(n,l.eye,Ir[0]),{stage:l}}function nx(n,t,e,i){let s=()=>[...n.querySelectorAll(".legend .energy:not([hidden])")];n.querySelector(".views").prepend(Tu(t,e,i,s))}function bT(n,t){let{span:e}=t,[i]=n,s=n.length===1?`${tl(i,t.clipTime(0))}, `:"",r=n.length===1?[...i.stages.map(({name:c})=>c),...i.marks.map(({letter:c,name:u})=>`${c} ${u}`)]:[],o=c=>Math.max(0,...c.map(u=>u.length)),a=`${s}${Yi(t.time,e)}`,l=[e.start,e.end].map(c=>Yi(c,e));return{text:a,longest:Math.max(a.length,o(r)+2+o(l))}}function ST(n,t,e){let i=S("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=tl(t,e.clipTime(0)),i.hidden=!i.textContent})}function ix(){return S("span",{className:"swatch arrow","aria-hidden":"true"})}function MT(n,t,e){let i=t.efforts.drives.some(o=>o.arrow),s=o=>c0(t.efforts,o,be).join("; ")||"no drive acts now",r=C0(Array.from(t.time,s));n.append(S("li",{className:"effort"},...i?[ix()]:[],r.element)),e.onChange(()=>r.say(s(e.clipTime(0))))}function Iu(n,t,e=!0){let i=Ir.map(l=>us(l.name,`${l.name}: view ${l.text}`,()=>n.show(l))),s=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([l,c,u])=>us(l,c,()=>n.turn(...u))),r=(l,c,u)=>{let h=us(l,c,()=>{n.choose({[u]:!n.look[u]}),h.setAttribute("aria-pressed",String(n.look[u]))});return h.setAttribute("aria-pressed",String(n.look[u])),h},o=[...e?[r("follow","follow: keep the picture filled as the structure moves","following")]:[],...t?[r("one scale",`one scale: draw all ${t}s at the same scale`,"oneScale")]:[]],a=[us("+","nearer",()=>n.zoom(1)),us("−","further",()=>n.zoom(-1))];return S("div",{className:"views",role:"group","aria-label":"view"},...o.length?[S("span",{},...o)]:[],S("span",{},...i),S("span",{className:"turns"},...s),S("span",{},...a))}var wT=4,AT={deg:.05};function ar(n,t,e,i,s=0,r=!1){let{heading:o,names:a}=t.mesh.parts,l=t.readings.map(b=>({name:b.name,title:b.row,parts:b.parts,text:v=>Tf(v,b.unit),ofState:v=>v.readings[b.name]&&ET(v.readings[b.name],b.unit)})),c=b=>be(i.factor*b);t.tendons&&l.push({name:Ts,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:c,ofState:b=>b.tendonEnergy_J?.map(c)});let u=l.map(()=>a.map(()=>S("td"))),h=S("caption"),d=l.map(b=>b.title),f=a.length>wT,[p,x]=f?[d,a]:[a,d],g=S("tr",{},o?S("th",{scope:"col"},o):S("td"),...p.map(b=>S("th",{scope:"col"},b))),m=x.map((b,v)=>S("tr",{},S("th",{scope:"row"},b),...f?u.map(E=>E[v]):u[v])),_=S("table",{className:"numbers"},h,S("thead",{},g),S("tbody",{},...m));return n.replaceChildren(S("div",{className:"table"},_)),n.classList.add("readout"),e.onChange(()=>{let b=e.clipTime(s),v=t.markAt(b),E=v?`, ${v.name}${v.tendonEnergy_J?" (means)":""}`:"",A=r?`${t.name}: `:"",y=o?`every ${o}`:"all values";h.textContent=`${Oe(`${A}${y}`)} at ${Yi(e.time,e.span)}${E}`;for(let[M,I]of l.entries()){let L=v&&I.ofState(v)||Array.from(t.valuesAt(I.name,b),I.text);for(let[C,D]of I.parts.entries())u[M][D].textContent=L[C]}})}function Tf(n,t){return t==="deg"?On(n,1):be(n)}function ET({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(AT[e]??.005*Math.abs(i));return`${Tf(i,e)}${r?` ± ${Tf(t[s],e)}`:""}`})}var TT=0;function Do(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)if(sx(i),i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)CT(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let e of n.querySelectorAll(".table"))t.observe(e),e.addEventListener("scroll",()=>sx(e),{passive:!0})}function sx(n){let t=Math.abs(n.scrollLeft);n.classList.toggle("more-left",t>1),n.classList.toggle("more-right",t+n.clientWidth<n.scrollWidth-1)}function CT(n){let{caption:t}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!t){let e=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",e.join(", ")||"table")}return t.id||=`caption-${++TT}`,n.setAttribute("aria-labelledby",t.id)}function RT(n,t){let e=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in t&&(e[o.number]=`${o.before}${ox(t[i],s,r)}${o.after}`);return e.join(`
`)}function rx({knobs:n},t,e){let{unit:i,factor:s}=n.find(r=>r.key===t);return ox(e,i,s)}function ox(n,t,e){return`${Number((e*n).toPrecision(12))} ${t}`}function ax(n){let t=S("a",{className:"button",download:"design.toml"},"This setting as a design file"),e=S("code"),i=S("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=S("div",{className:"setting"},t,S("pre",{},e),i);function r(o){let a=new TextEncoder().encode(RT(n,o));t.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,e.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var lx=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]],el=Object.fromEntries(lx.map(([,,n,t])=>[n,t])),Lu=n=>S("select",{},...n.map(([t,e])=>S("option",{value:e},t)));function Nu(n,{clicked:t,pressed:e}){let i=lx.map(([r,o,a])=>{let l=S("button",{type:"button",title:`${n} ${o}`,"aria-label":`${n} ${o}`,"data-way":a},r);return l.addEventListener("click",()=>t(a)),l}),s=S("span",{className:"pad",role:"group","aria-label":`${n} in the plane of the picture`},...i);return s.addEventListener("keydown",r=>{!(r.key in el)||r.shiftKey||r.ctrlKey||r.metaKey||r.altKey||(r.preventDefault(),r.stopPropagation(),e(r.key))}),s}var PT=500,cx=[["a little",.1],["half",.5],["as strong as its drives",1]];function ux(n,t,e,i,s){let r=Lu(e.map((_,b)=>[_,b]).filter(([,_])=>t.movable[_])),o=S("select",{},...cx.map(([_,b])=>S("option",{value:b,selected:b===cx[0][1]},_))),a=S("span",{className:"note",role:"status"}),l=Nu("push",{clicked:m,pressed:g}),c=S("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),u=S("details",{className:"push-keys"},S("summary",{},"Push without a pointer"),S("div",{className:"choices"},S("label",{},"point ",r),S("label",{},"force ",o),l,a),c),h=IT(n,t,()=>Number(r.value),u),d=new Set,f=0;function p(){clearTimeout(f);let[_,b]=[0,1].map(A=>[...d].reduce((y,M)=>y+el[M][A],0));if(!_&&!b){a.textContent="",s(0,null);return}let{camera:v}=n.eye,E=new V().setFromMatrixColumn(v.matrixWorld,0).multiplyScalar(_);E.addScaledVector(new V().setFromMatrixColumn(v.matrixWorld,1),b).setLength(Number(o.value)*i),a.textContent=`${r.selectedOptions[0].text} pushed with ${be(E.length())} N`,s(Number(r.value),E.toArray())}function x(){d.size&&(d.clear(),p())}function g(_){d.has(_)||(d.add(_),p())}function m(_){d.clear(),d.add(_),p(),f=setTimeout(x,PT)}return l.addEventListener("keyup",({key:_})=>{d.delete(_)&&p()}),l.addEventListener("focusout",x),r.addEventListener("change",()=>{x(),h()}),u.addEventListener("toggle",h),u}function IT(n,t,e,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new V;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let[c,u]=Lo(a.fromArray(t.frame.points,3*e()),n.eye.camera,n.canvas);o.setAttribute("cx",c),o.setAttribute("cy",u)}return t.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var LT=22;function Du(n,{points:t,movable:e,between:i=()=>null,moved:s,left:r}){let{canvas:o,eye:a}=n,l=document.createElementNS("http://www.w3.org/2000/svg","line"),c=document.createElementNS("http://www.w3.org/2000/svg","svg");c.classList.add("push"),c.setAttribute("aria-hidden","true"),c.append(l);let u=S("p",{className:"pushed","aria-hidden":"true"});n.element.append(c,u),c.style.display="none";let[h,d]=[new V,new V],f=null,p=null;function x(y){d.set(0,0,0);for(let[M,I]of y)d.addScaledVector(h.fromArray(t(),3*M),I);return d}function g(y){return Lo(x(y),a.camera,o)}function m(y){let M=o.getBoundingClientRect();return[y.clientX-M.left,y.clientY-M.top]}function _([y,M]){let I={place:null,away:LT};for(let L=0;L<e.length;L++){if(!e[L])continue;let C=[[L,1]],[D,k]=g(C),N=Math.hypot(D-y,k-M);N<I.away&&(I={place:C,away:N})}return I.place}let b=([y,M])=>[2*y/o.clientWidth-1,1-2*M/o.clientHeight],v=y=>_(m(y))??i(...b(m(y)));function E(){if(!f)return;let y=g(f);for(let[M,I]of[["x1",y[0]],["y1",y[1]],["x2",p[0]],["y2",p[1]]])l.setAttribute(M,I);c.style.display=""}o.addEventListener("pointerdown",y=>{f=y.button===0?v(y):null,f&&(a.controls.enabled=!1,o.setPointerCapture(y.pointerId),y.stopImmediatePropagation())},{capture:!0}),o.addEventListener("pointermove",y=>{if(!f){o.classList.toggle("grip",v(y)!==null);return}p=m(y);let M=x(f).clone(),I=M.clone().project(a.camera).z;s(f,M,new V(...b(p),I).unproject(a.camera)),E()});let A=()=>{f&&(f=null,a.controls.enabled=!0,c.style.display="none",u.textContent="",r())};return o.addEventListener("pointerup",A),o.addEventListener("pointercancel",A),n.onDraw(E),{say:y=>u.textContent=y}}var NT=.25;function hx(n,t,e,i,s){let{say:r}=Du(n,{points:()=>t.frame.points,movable:t.movable,moved([[o]],a,l){let c=l.sub(a).multiplyScalar(i/(NT*e)).clampLength(0,i);s(o,c.toArray()),r(`pushed with ${be(c.length())} N`)},left:()=>s(0,null)})}var nl=200,DT=20,OT=3;function dx(n,t,e){let i=n.map(o=>UT(o,t,e)),s=S("button",{type:"button",disabled:!0},`Reset all to ${t}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=S("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function UT(n,t,e){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=DT,u=E=>c?a*(l/a)**E:a+E*(l-a),h=E=>c?Math.log(E/a)/Math.log(l/a):(E-a)/(l-a),d=Math.round(nl*h(n.value)),f=Oe(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=S("input",{type:"range",min:0,max:nl,step:1,"aria-label":f,"aria-description":s}),x=S("output"),g=S("span",{className:"home",title:`in ${t}`,"aria-hidden":"true"});g.style.left=`${100*d/nl}%`,p.dataset.keys="own";let m=n.value;function _(){let E=`${be(o*m)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;x.textContent=E,p.setAttribute("aria-valuetext",m===n.value?`${E}, as in ${t}`:E),v.classList.toggle("changed",m!==n.value)}function b(E){m=E,p.value=Math.round(nl*h(m)),_(),e(i,m)}p.addEventListener("input",()=>{let E=Number(p.value);m=E===d?n.value:Number((o*u(E/nl)).toPrecision(OT))/o,_(),e(i,m)});let v=S("label",{className:"slider",title:`${i}: ${s}`},S("span",{className:"name"},f),x,S("span",{className:"rail"},p,g));return p.value=d,_(),{element:v,knob:n,get value(){return m},put:b,reset:()=>b(n.value)}}var kT=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],FT=.2,Ou=1.4,BT="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",zT=1e-15;async function Oo(n,t,e,i,{look:s,pace:r=FT,set:o}={}){let a=JSON.parse(e),l={frame:null,engine:null,pace:r},c=await i(e,M=>A(M)),u=b0(n,a,c.first),h=S("p",{className:"verdict",role:"status"}),d=S("p",{className:"note"}),f=S("p",{className:"time"}),p=S("p",{className:"account"}),x=S("div"),g=S("div"),m=ax(a),_=dx(a.knobs,t.kind==="bench"?"the design":"this run",(M,I)=>{c.send({act:"set",values:{[M]:I}}),_.refresh(),m.refresh(_.changes),o?.(M,rx(a,M,I))}),b=GT(a,c,l,()=>{h.textContent="",d.textContent=""}),v=a.motors.every(M=>M.kind==="torque")?"torques":"drives",E=null;function A(M){if(M.said==="refused"){h.textContent=`The simulator stopped: ${M.why}.`;return}M.said==="frame"&&y(M.frame)}function y(M){l.frame=M,u.show(M),f.textContent=`${Yi(M.time_s,{start:0,end:Math.max(1,M.time_s)})}${HT(M,a.protocol)}`;let I=M.energies_J.reduce((N,B)=>N+B,0),L=M.works_J.reduce((N,B)=>N+B,0),C=[...n.tendons?[`tendon energy ${Cf(I)}`]:[],`work of the ${v} ${Cf(L)}`];p.textContent=C.join(" · ");let D=M.stageNumber===null?M.ended:null,k=D&&JSON.stringify([D.verdict,...D.stages.map(N=>N.end_s)]);k!==E&&(h.textContent=D?WT(D,t.whole,a.texts.outcome):"",d.textContent=[D?.advice,D&&M.meddled&&BT].filter(Boolean).join(" ")),E=k}return l.element=S("div",{className:"trial"},S("div",{className:"head"},S("div",{className:"choices"},...b),S("div",{className:"live-facts"},f,p),h,d),x,S("div",{className:"hands"},_.element,...o?[]:[m.element]),g),l.begin=()=>{let M=s??{...ir(),following:!1,closer:t.kind==="bench"?Ou:1},{stage:I}=Pu(x,[u.clip],u.clock,{...t,text:`${t.shape}, live.`},M);if(l.stage=I,ar(g,u.clip,u.clock,t.energy),Do(l.element),I){u.movable=a.anchors.bodies.map(D=>D>0);let L=VT(a,n.mesh.span_m),C=(D,k)=>c.send({act:"push",point:D,force:k});hx(I,u,n.mesh.span_m,L,C),x.querySelector(".picture").after(ux(I,u,a.anchors.names,L,C))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),t.kind!=="bench"&&b[0].focus({preventScroll:!0})},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:u,sliders:_,design:m,own:a})}function VT({protocol:n,motors:t},e){let i=n.drives.map(({strength:s,torques:r})=>{let o=t[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/e:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function GT({protocol:n},t,e,i){let s=(a,l,c)=>{let u=S("button",{type:"button",title:c});return u.append(a),u.addEventListener("click",()=>{i(),t.send(l)}),u},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let u=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),h=(u<0?n.stages.length:u)-1;return[s(Oe(a),{act:"stages",from:c,to:h},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=S("select",{},...kT.map(([a,l])=>S("option",{value:l,selected:l===e.pace},a)));return o.addEventListener("change",()=>{e.pace=Number(o.value),t.send({act:"pace",value:e.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),S("label",{},"speed ",o)]}function HT({stage:n,stageNumber:t,running:e,ended:i},{stages:s}){let r=n&&!s[t].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${Fs(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:e?" · no drive acts":" · at rest"}function WT({status:n,verdict:t,transitions:e},i,s){let r=e.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>Lh(s.transition,{did:o.did||o.done,time:Fs(a.time_s,"s"),work:Cf(a.work_J)}));return r.length?Lh(s[t==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${Oe(n)}.`}var Cf=n=>Fs(Math.abs(n)<zT?0:n,"J");function Uu(n,t,e,i,s=null){if(!n)return null;let r={panel:null,failed:"",start:null},o=document.getElementById("live").textContent,a=S("button",{type:"button",className:"try"},"Try it"),l=S("p",{className:"note"});l.textContent=`Move this ${e.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(S("div",{className:"offer"},a,l));function c(h){r.failed=h,a.disabled=!0;let d="To drag its vertices, open the design in the workbench, with the command forficula open.",f=`A page cannot simulate the motion in time of this ${e.whole}: ${h}.`;if(l.textContent=`${s?`A slider folds this ${e.whole} along its quasi-static path. `:""}${d} ${f}`,!s)return;let p=S("button",{type:"button",className:"try"},"Fold it slowly");p.addEventListener("click",s),a.replaceWith(p)}let u=JSON.parse(o.startsWith('{"refused"')?o:"null");return u!==null?c(u.refused):xu()||c("this page was written without the engine"),r.start=async()=>{if(!a.disabled){a.disabled=!0,l.setAttribute("role","status"),l.textContent="Starting the simulator …",i();try{r.panel=await Oo(t,e,o,Io),n.replaceChildren(S("h2",{},"Try it"),r.panel.element),r.panel.begin()}catch(h){c(h.message)}}},a.addEventListener("click",async()=>{await r.start(),r.failed||n.scrollIntoView({block:"start"})}),r}function fx(n){let t=Jn(n.clips[0]),e=Uu(document.getElementById("try"),t,n,()=>{});return e.start(),{clips:[t],trial:e}}var $T=200;function Ui(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,Q0(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(_){return h()?u().wayAt(_):(_-s.start)/(s.end-s.start||1)}function f(_){return h()?u().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(x))}function x(_){if(l=0,o){let b=Math.min((_-a)/1e3,.1);a=_,g(b),l=requestAnimationFrame(x)}for(let b of e)b()}function g(_){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+_/u().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function m(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(_,b=i)=>Math.min(n[_].end,Math.max(n[_].start,b+s.origins[_])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:_=>u().wayAt(_),timeAt:_=>u().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=u().wayAt(i),[b,v]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(v-b)*u().seconds/(u().timeAt(v)-u().timeAt(b)||1e-12)},onChange(_){return e.add(_),p(),()=>e.delete(_)},seek:m,seekClip(_,b){(b<s.start+s.origins[_]||b>s.end+s.origins[_])&&(s=t.find(v=>b>=v.start+v.origins[_]&&b<=v.end+v.origins[_])??t[0]),m(b-s.origins[_])},step:_=>m(f(d(i)+_/$T)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,m(i<s.start||i>s.end?s.start:i)},redraw:p}}var XT="uplot",qT="u-hz",YT="u-vt",ZT="u-title",KT="u-wrap",JT="u-under",jT="u-over",QT="u-axis",Dr="u-off",tC="u-select",eC="u-cursor-x",nC="u-cursor-y",iC="u-cursor-pt",sC="u-legend",rC="u-live",oC="u-inline",aC="u-series",lC="u-marker",px="u-label",cC="u-value",sl="width",rl="height";var mx="bottom",Uo="left",Rf="right",Xf="#000",gx=Xf+"0",Pf="mousemove",xx="mousedown",If="mouseup",_x="mouseenter",yx="mouseleave",vx="dblclick",uC="resize",hC="scroll",bx="change",Vu="dppxchange",qf="--",Ho=typeof window<"u",Uf=Ho?document:null,Fo=Ho?window:null,dC=Ho?navigator:null,Ee,ku;function kf(){let n=devicePixelRatio;Ee!=n&&(Ee=n,ku&&Bf(bx,ku,kf),ku=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),Or(bx,ku,kf),Fo.dispatchEvent(new CustomEvent(Vu)))}function pi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Ff(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ye(n,t,e){n.style[t]=e+"px"}function ki(n,t,e,i){let s=Uf.createElement(n);return t!=null&&pi(s,t),e?.insertBefore(s,i),s}function Mi(n,t){return ki("div",n,t)}var Sx=new WeakMap;function is(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Sx.get(n);r!=o&&(n.style.transform=r,Sx.set(n,r),t<0||e<0||t>i||e>s?pi(n,Dr):Ff(n,Dr))}var Mx=new WeakMap;function wx(n,t,e){let i=t+e,s=Mx.get(n);i!=s&&(Mx.set(n,i),n.style.background=t,n.style.borderColor=e)}var Ax=new WeakMap;function Ex(n,t,e,i){let s=t+""+e,r=Ax.get(n);s!=r&&(Ax.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Yf={passive:!0},fC={...Yf,capture:!0};function Or(n,t,e,i){t.addEventListener(n,e,i?fC:Yf)}function Bf(n,t,e,i){t.removeEventListener(n,e,Yf)}Ho&&kf();function Fi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:mi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function t_(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var e_=n=>n!=null,n_=n=>n!=null&&n>0,Wu=t_(e_),pC=t_(n_);function mC(n,t,e,i=0,s=!1){let r=s?pC:Wu,o=s?n_:e_;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Be,l??-Be]}function $u(n,t,e,i){let s=Rx(n),r=Rx(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Cs:i_,a=s==1?mi:wi,l=r==1?wi:mi,c=a(o(An(n))),u=l(o(An(t))),h=Bo(e,c),d=Bo(e,u);return e==10&&(c<0&&(h=ze(h,-c)),u<0&&(d=ze(d,-u))),i||e==2?(n=h*s,t=d*r):(n=a_(n,h),t=Xu(t,d)),[n,t]}function Zf(n,t,e,i){let s=$u(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Kf=.1,Tx={mode:3,pad:Kf},al={pad:0,soft:null,mode:0},gC={min:al,max:al};function Gu(n,t,e,i){return qu(e)?Cx(n,t,e):(al.pad=e,al.soft=i?0:null,al.mode=i?3:0,Cx(n,t,gC))}function Me(n,t){return n??t}function xC(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Cx(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-Be),l=Me(s.hard,Be),c=Me(i.soft,Be),u=Me(s.soft,-Be),h=Me(i.mode,0),d=Me(s.mode,0),f=t-n,p=Cs(f),x=jn(An(n),An(t)),g=Cs(x),m=An(g-p);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Be&&(r=0),d==2&&u!=-Be&&(o=0)));let _=f||x||1e3,b=Cs(_),v=Bo(10,mi(b)),E=_*(f==0?n==0?.1:1:r),A=ze(a_(n-E,v/10),24),y=n>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:Be,M=jn(a,A<y&&n>=y?y:Bi(y,A)),I=_*(f==0?t==0?.1:1:o),L=ze(Xu(t+I,v/10),24),C=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Be,D=Bi(l,L>C&&t<=C?C:jn(C,L));return M==D&&M==0&&(D=100),[M,D]}var _C=new Intl.NumberFormat(Ho?dC.language:"en-US"),Jf=n=>_C.format(n),gi=Math,zu=gi.PI,An=gi.abs,mi=gi.floor,wn=gi.round,wi=gi.ceil,Bi=gi.min,jn=gi.max,Bo=gi.pow,Rx=gi.sign,Cs=gi.log10,i_=gi.log2,yC=(n,t=1)=>gi.sinh(n)*t,Lf=(n,t=1)=>gi.asinh(n/t),Be=1/0;function Px(n){return(Cs((n^n>>31)-(n>>31))|0)+1}function zf(n,t,e){return Bi(jn(n,t),e)}function s_(n){return typeof n=="function"}function ye(n){return s_(n)?n:()=>n}var vC=()=>{},r_=n=>n,o_=(n,t)=>t,bC=n=>null,Ix=n=>!0,Lx=(n,t)=>n==t,SC=/\.\d*?(?=9{6,}|0{6,})/gm,Ur=n=>{if(c_(n)||cr.has(n))return n;let t=`${n}`,e=t.match(SC);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Ur(s)}e${r}`}return ze(n,i)};function Lr(n,t){return Ur(ze(Ur(n/t))*t)}function Xu(n,t){return Ur(wi(Ur(n/t))*t)}function a_(n,t){return Ur(mi(Ur(n/t))*t)}function ze(n,t=0){if(c_(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return wn(i)/e}var cr=new Map;function l_(n){return((""+n).split(".")[1]||"").length}function cl(n,t,e,i){let s=[],r=i.map(l_);for(let o=t;o<e;o++){let a=An(o),l=ze(Bo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:ze(u,h);s.push(d),cr.set(d,h)}}return s}var ll={},jf=[],zo=[null,null],lr=Array.isArray,c_=Number.isInteger,MC=n=>n===void 0;function Nx(n){return typeof n=="string"}function qu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function wC(n){return n!=null&&typeof n=="object"}var AC=Object.getPrototypeOf(Uint8Array),u_="__proto__";function Vo(n,t=qu){let e;if(lr(n)){let i=n.find(s=>s!=null);if(lr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Vo(n[s],t)}else e=n.slice()}else if(n instanceof AC)e=n.slice();else if(t(n)){e={};for(let i in n)i!=u_&&(e[i]=Vo(n[i],t))}else e=n;return e}function xn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=u_&&(qu(n[s])?xn(n[s],Vo(i[s])):n[s]=Vo(i[s]))}return n}var EC=0,TC=1,CC=2;function RC(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function PC(n,t){if(NC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return DC(o[0])||(o=LC(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:TC,f=[];for(let p=0;p<u.length;p++){let x=u[p],g=r.get(l[p]);x===null?d!=EC&&(h[g]=x,d==CC&&f.push(g)):h[g]=x}RC(h,f,s),i.push(h)}}return i}var IC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function LC(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function NC(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function DC(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,mi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var h_=["January","February","March","April","May","June","July","August","September","October","November","December"],d_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function f_(n){return n.slice(0,3)}var OC=d_.map(f_),UC=h_.map(f_),kC={MMMM:h_,MMM:UC,WWWW:d_,WWW:OC};function il(n){return(n<10?"0":"")+n}function FC(n){return(n<10?"00":n<100?"0":"")+n}var BC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>il(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>il(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>il(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>il(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>il(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>FC(n.getMilliseconds())};function Qf(n,t){t=t||kC;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?BC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var zC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function VC(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==zC?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var p_=n=>n%1==0,Hu=[1,2,2.5,5],GC=cl(10,-32,0,Hu),m_=cl(10,0,32,Hu),HC=m_.filter(p_),Nr=GC.concat(m_),tp=`
`,g_="{YYYY}",Dx=tp+g_,x_="{M}/{D}",ol=tp+x_,Fu=ol+"/{YY}",__="{aa}",WC="{h}:{mm}",ko=WC+__,Ox=tp+ko,Ux=":{ss}",Re=null;function y_(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?cl(10,0,3,Hu).filter(p_):cl(10,-3,0,Hu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,g_,Re,Re,Re,Re,Re,Re,1],[s*28,"{MMM}",Dx,Re,Re,Re,Re,Re,1],[s,x_,Dx,Re,Re,Re,Re,Re,1],[i,"{h}"+__,Fu,Re,ol,Re,Re,Re,1],[e,ko,Fu,Re,ol,Re,Re,Re,1],[t,Ux,Fu+" "+ko,Re,ol+" "+ko,Re,Ox,Re,1],[n,Ux+".{fff}",Fu+" "+ko,Re,ol+" "+ko,Re,Ox,Re,1]];function u(h){return(d,f,p,x,g,m)=>{let _=[],b=g>=o,v=g>=r&&g<o,E=h(p),A=ze(E*n,3),y=Nf(E.getFullYear(),b?0:E.getMonth(),v||b?1:E.getDate()),M=ze(y*n,3);if(v||b){let I=v?g/r:0,L=b?g/o:0,C=A==M?A:ze(Nf(y.getFullYear()+L,y.getMonth()+I,1)*n,3),D=new Date(wn(C/n)),k=D.getFullYear(),N=D.getMonth();for(let B=0;C<=x;B++){let W=Nf(k+L*B,N+I*B,1),H=W-h(ze(W*n,3));C=ze((+W+H)*n,3),C<=x&&_.push(C)}}else{let I=g>=s?s:g,L=mi(p)-mi(A),C=M+L+Xu(A-M,I);_.push(C);let D=h(C),k=D.getHours()+D.getMinutes()/e+D.getSeconds()/i,N=g/i,B=d.axes[f]._space,W=m/B;for(;C=ze(C+g,n==1?0:3),!(C>x);)if(N>1){let H=mi(ze(k+N,6))%24,Q=h(C).getHours()-H;Q>1&&(Q=-1),C-=Q*i,k=(k+N)%24;let it=_[_.length-1];ze((C-it)/g,3)*W>=.7&&_.push(C)}else _.push(C)}return _}}return[l,c,u]}var[$C,XC,qC]=y_(1),[YC,ZC,KC]=y_(.001);cl(2,-53,53,[1]);function kx(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Fx(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let x=n(p),g=x.getFullYear(),m=x.getMonth(),_=x.getDate(),b=x.getHours(),v=x.getMinutes(),E=x.getSeconds(),A=g!=l&&a[2]||m!=c&&a[3]||_!=u&&a[4]||b!=h&&a[5]||v!=d&&a[6]||E!=f&&a[7]||a[1];return l=g,c=m,u=_,h=b,d=v,f=E,A(x)})}}function JC(n,t){let e=Qf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Nf(n,t,e){return new Date(n,t,e)}function Bx(n,t){return t(n)}var jC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function zx(n,t){return(e,i,s,r)=>r==null?qf:t(n(i))}function QC(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function tR(n,t){return n.series[t].fill(n,t)}var eR={show:!0,live:!0,isolate:!1,mount:vC,markers:{show:!0,width:2,stroke:QC,fill:tR,dash:"solid"},idx:null,idxs:null,values:[]};function nR(n,t){let e=n.cursor.points,i=Mi(),s=e.size(n,t);Ye(i,sl,s),Ye(i,rl,s);let r=s/-2;Ye(i,"marginLeft",r),Ye(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ye(i,"borderWidth",o),i}function iR(n,t){let e=n.series[t].points;return e._fill||e._stroke}function sR(n,t){let e=n.series[t].points;return e._stroke||e._fill}function rR(n,t){return n.series[t].points.size}var Df=[0,0];function oR(n,t,e){return Df[0]=t,Df[1]=e,Df}function Bu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Of(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var aR={show:!0,x:!0,y:!0,lock:!1,move:oR,points:{one:!1,show:nR,size:rR,width:0,stroke:sR,fill:iR},bind:{mousedown:Bu,mouseup:Bu,click:Bu,dblclick:Bu,mousemove:Of,mouseleave:Of,mouseenter:Of},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},v_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ep=xn({},v_,{filter:o_}),b_=xn({},ep,{size:10}),S_=xn({},v_,{show:!1}),np='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',M_="bold "+np,w_=1.5,Vx={show:!0,scale:"x",stroke:Xf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M_,side:2,grid:ep,ticks:b_,border:S_,font:np,lineGap:w_,rotate:0},lR="Value",cR="Time",Gx={show:!0,scale:"x",auto:!1,sorted:1,min:Be,max:-Be,idxs:[]};function uR(n,t,e,i,s){return t.map(r=>r==null?"":Jf(r))}function hR(n,t,e,i,s,r,o){let a=[],l=cr.get(s)||0;e=o?e:ze(Xu(e,s),l);for(let c=e;c<=i;c=ze(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Vf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Cs:i_,u=mi(c(e));s=Bo(l,u),l==10&&(s=Nr[Fi(s,Nr)]);let h=e,d=s*l;l==10&&(d=Nr[Fi(d,Nr)]);do a.push(h),h=h+s,l==10&&!cr.has(h)&&(h=ze(h,cr.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Nr[Fi(d,Nr)]));while(h<=i);return a}function dR(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Vf(n,t,jn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Vf(n,t,jn(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var A_=/./,fR=/[12357]/,pR=/[125]/,Hx=/1/,Gf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function mR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?A_:l(7,o)-u>=c?fR:l(5,o)-u>=c?pR:Hx;if(h==Hx){let d=An(l(1,o)-u);if(d<c)return Gf(t.slice().reverse(),a.distr,h,wi(c/d)).reverse()}return Gf(t,a.distr,h,1)}function gR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=An(l(1,o)-l(2,o));return c<a?Gf(t.slice().reverse(),3,A_,wi(a/c)).reverse():t}function xR(n,t,e,i){return i==null?qf:t==null?"":Jf(t)}var Wx={show:!0,scale:"y",stroke:Xf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:M_,side:3,grid:ep,ticks:b_,border:S_,font:np,lineGap:w_,rotate:0};function _R(n,t){let e=3+(n||1)*2;return ze(e*t,3)}function yR(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=An(o-r),l=n.series[t],c=a/(l.points.space*Ee);return i[1]-i[0]<=c}var $x={scale:null,auto:!0,sorted:0,min:Be,max:-Be},E_=(n,t,e,i,s)=>s,Xx={show:!0,auto:!0,sorted:0,gaps:E_,alpha:1,facets:[xn({},$x,{scale:"x"}),xn({},$x,{scale:"y"})]},qx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:E_,alpha:1,points:{show:yR,filter:null},values:null,min:Be,max:-Be,idxs:[],path:null,clip:null};function vR(n,t,e,i,s){return e/10}var T_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},bR=xn({},T_,{time:!1,ori:1}),Yx={};function C_(n,t){let e=Yx[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Yx[n]=e)),e}var Go=1,Hf=2;function kr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?e(s,l,c,u,h,g,m,d,f,p,x,Zu,Wo,Ju,P_,L_):e(s,l,c,u,h,m,g,f,d,x,p,Ku,$o,rp,I_,N_)}function ip(n,t){let e=0,i=0,s=Me(n.bands,jf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function SR(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Rs(n,t,e,i,s,r){return kr(n,t,(o,a,l,c,u,h,d,f,p,x,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),b=c.ori==0?Wo:$o,v,E;_==1?(v=e,E=i):(v=i,E=e);let A=m(h(a[v],c,x,f)),y=m(d(l[v],u,g,p)),M=m(h(a[E],c,x,f)),I=m(d(r==1?u.max:u.min,u,g,p)),L=new Path2D(s);return b(L,M,I),b(L,A,I),b(L,A,y),L})}function Yu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Ju:rp,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function MR(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function sp(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=f&&a.push([f,p])}return a}function Zx(n){return n==0?r_:n==1?wn:t=>Lr(t,n)}function R_(n){let t=n==0?Zu:Ku,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Bi(c,a/2,l/2),u=Bi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Zu=(n,t,e)=>{n.moveTo(t,e)},Ku=(n,t,e)=>{n.moveTo(e,t)},Wo=(n,t,e)=>{n.lineTo(t,e)},$o=(n,t,e)=>{n.lineTo(e,t)},Ju=R_(0),rp=R_(1),P_=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},I_=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},L_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},N_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function D_(n){return(t,e,i,s,r)=>kr(t,e,(o,a,l,c,u,h,d,f,p,x,g)=>{let{pxRound:m,points:_}=o,b,v;c.ori==0?(b=Zu,v=P_):(b=Ku,v=I_);let E=ze(_.width*Ee,3),A=(_.size-_.width)/2*Ee,y=ze(A*2,3),M=new Path2D,I=new Path2D,{left:L,top:C,width:D,height:k}=t.bbox;Ju(I,L-y,C-y,D+y*2,k+y*2);let N=B=>{if(l[B]!=null){let W=m(h(a[B],c,x,f)),H=m(d(l[B],u,g,p));b(M,W+A,H),v(M,W,H,A,0,zu*2)}};if(r)r.forEach(N);else for(let B=i;B<=s;B++)N(B);return{stroke:E>0?M:null,fill:M,clip:I,flags:Go|Hf}})}function O_(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var wR=O_(Wo),AR=O_($o);function U_(n){let t=Me(n?.alignGaps,0);return(e,i,s,r)=>kr(e,i,(o,a,l,c,u,h,d,f,p,x,g)=>{[s,r]=Wu(l,s,r);let m=o.pxRound,_=k=>m(h(k,c,x,f)),b=k=>m(d(k,u,g,p)),v,E;c.ori==0?(v=Wo,E=wR):(v=$o,E=AR);let A=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Go},M=y.stroke,I=!1;if(r-s>=x*4){let k=dt=>e.posToVal(dt,c.key,!0),N=null,B=null,W,H,st,Y=_(a[A==1?s:r]),Q=_(a[s]),it=_(a[r]),ft=k(A==1?Q+1:it-1);for(let dt=A==1?s:r;dt>=s&&dt<=r;dt+=A){let tt=a[dt],gt=(A==1?tt<ft:tt>ft)?Y:_(tt),St=l[dt];gt==Y?St!=null?(H=St,N==null?(v(M,gt,b(H)),W=N=B=H):H<N?N=H:H>B&&(B=H)):St===null&&(I=!0):(N!=null&&E(M,Y,b(N),b(B),b(W),b(H)),St!=null?(H=St,v(M,gt,b(H)),N=B=W=H):(N=B=null,St===null&&(I=!0)),Y=gt,ft=k(Y+A))}N!=null&&N!=B&&st!=Y&&E(M,Y,b(N),b(B),b(W),b(H))}else for(let k=A==1?s:r;k>=s&&k<=r;k+=A){let N=l[k];N===null?I=!0:N!=null&&v(M,_(a[k]),b(N))}let[C,D]=ip(e,i);if(o.fill!=null||C!=0){let k=y.fill=new Path2D(M),N=o.fillTo(e,i,o.min,o.max,C),B=b(N),W=_(a[s]),H=_(a[r]);A==-1&&([H,W]=[W,H]),v(k,H,B),v(k,W,B)}if(!o.spanGaps){let k=[];I&&k.push(...sp(a,l,s,r,A,_,t)),y.gaps=k=o.gaps(e,i,s,r,k),y.clip=Yu(k,c.ori,f,p,x,g)}return D!=0&&(y.band=D==2?[Rs(e,i,s,r,M,-1),Rs(e,i,s,r,M,1)]:Rs(e,i,s,r,M,D)),y})}function ER(n){let t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,l)=>kr(r,o,(c,u,h,d,f,p,x,g,m,_,b)=>{[a,l]=Wu(h,a,l);let v=c.pxRound,{left:E,width:A}=r.bbox,y=Q=>v(p(Q,d,_,g)),M=Q=>v(x(Q,f,b,m)),I=d.ori==0?Wo:$o,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Go},C=L.stroke,D=d.dir*(d.ori==0?1:-1),k=M(h[D==1?a:l]),N=y(u[D==1?a:l]),B=N,W=N;s&&t==-1&&(W=E,I(C,W,k)),I(C,N,k);for(let Q=D==1?a:l;Q>=a&&Q<=l;Q+=D){let it=h[Q];if(it==null)continue;let ft=y(u[Q]),dt=M(it);t==1?I(C,ft,k):I(C,B,dt),I(C,ft,dt),k=dt,B=ft}let H=B;s&&t==1&&(H=E+A,I(C,H,k));let[st,Y]=ip(r,o);if(c.fill!=null||st!=0){let Q=L.fill=new Path2D(C),it=c.fillTo(r,o,c.min,c.max,st),ft=M(it);I(Q,H,ft),I(Q,W,ft)}if(!c.spanGaps){let Q=[];Q.push(...sp(u,h,a,l,D,y,i));let it=c.width*Ee/2,ft=e||t==1?it:-it,dt=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=Yu(Q,d.ori,g,m,_,b)}return Y!=0&&(L.band=Y==2?[Rs(r,o,a,l,C,-1),Rs(r,o,a,l,C,1)]:Rs(r,o,a,l,C,Y)),L})}function Kx(n,t,e,i,s,r,o=Be){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=An(n[l]-n[a]);u<c&&(c=u,o=An(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function TR(n){n=n||ll;let t=Me(n.size,[.6,Be,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ye(s),o=1-t[0],a=Me(t[1],Be),l=Me(t[2],1),c=Me(n.disp,ll),u=Me(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,x,g)=>kr(f,p,(m,_,b,v,E,A,y,M,I,L,C)=>{let D=m.pxRound,k=e,N=i*Ee,B=a*Ee,W=l*Ee,H,st;v.ori==0?[H,st]=r(f,p):[st,H]=r(f,p);let Y=v.dir*(v.ori==0?1:-1),Q=v.ori==0?Ju:rp,it=v.ori==0?u:(Rt,Zt,re,wt,ke,zt,Xt)=>{u(Rt,Zt,re,ke,wt,Xt,zt)},ft=Me(f.bands,jf).find(Rt=>Rt.series[0]==p),dt=ft!=null?ft.dir:0,tt=m.fillTo(f,p,m.min,m.max,dt),ht=D(y(tt,E,C,I)),gt,St,Mt,Ht=L,se=D(m.width*Ee),Vt=!1,he=null,le=null,ne=null,Ze=null;h!=null&&(se==0||d!=null)&&(Vt=!0,he=h.values(f,p,x,g),le=new Map,new Set(he).forEach(Rt=>{Rt!=null&&le.set(Rt,new Path2D)}),se>0&&(ne=d.values(f,p,x,g),Ze=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&Ze.set(Rt,new Path2D)})));let{x0:Ve,size:cn}=c;if(Ve!=null&&cn!=null){k=1,_=Ve.values(f,p,x,g),Ve.unit==2&&(_=_.map(re=>f.posToVal(M+re*L,v.key,!0)));let Rt=cn.values(f,p,x,g);cn.unit==2?St=Rt[0]*L:St=A(Rt[0],v,L,M)-A(0,v,L,M),Ht=Kx(_,b,A,v,L,M,Ht),Mt=Ht-St+N}else Ht=Kx(_,b,A,v,L,M,Ht),Mt=Ht*o+N,St=Ht-Mt;Mt<1&&(Mt=0),se>=St/2&&(se=0),Mt<5&&(D=r_);let Ne=Mt>0,En=Ht-Mt-(Ne?se:0);St=D(zf(En,W,B)),gt=(k==0?St/2:k==Y?0:St)-k*Y*((k==0?N/2:0)+(Ne?se/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},_n=Vt?null:new Path2D,je=null;if(ft!=null)je=f.data[ft.series[1]];else{let{y0:Rt,y1:Zt}=c;Rt!=null&&Zt!=null&&(b=Zt.values(f,p,x,g),je=Rt.values(f,p,x,g))}let un=H*St,G=st*St;for(let Rt=Y==1?x:g;Rt>=x&&Rt<=g;Rt+=Y){let Zt=b[Rt];if(Zt==null)continue;if(je!=null){let q=je[Rt]??0;if(Zt-q==0)continue;ht=y(q,E,C,I)}let re=v.distr!=2||c!=null?_[Rt]:Rt,wt=A(re,v,L,M),ke=y(Me(Zt,tt),E,C,I),zt=D(wt-gt),Xt=D(jn(ke,ht)),O=D(Bi(ke,ht)),T=Xt-O;if(Zt!=null){let q=Zt<0?G:un,ut=Zt<0?un:G;Vt?(se>0&&ne[Rt]!=null&&Q(Ze.get(ne[Rt]),zt,O+mi(se/2),St,jn(0,T-se),q,ut),he[Rt]!=null&&Q(le.get(he[Rt]),zt,O+mi(se/2),St,jn(0,T-se),q,ut)):Q(_n,zt,O+mi(se/2),St,jn(0,T-se),q,ut),it(f,p,Rt,zt-se/2,O,St+se,T)}}return se>0?ve.stroke=Vt?Ze:_n:Vt||(ve._fill=m.width==0?m._fill:m._stroke??m._fill,ve.width=0),ve.fill=Vt?le:_n,ve})}function CR(n,t){let e=Me(t?.alignGaps,0);return(i,s,r,o)=>kr(i,s,(a,l,c,u,h,d,f,p,x,g,m)=>{[r,o]=Wu(c,r,o);let _=a.pxRound,b=H=>_(d(H,u,g,p)),v=H=>_(f(H,h,m,x)),E,A,y;u.ori==0?(E=Zu,y=Wo,A=L_):(E=Ku,y=$o,A=N_);let M=u.dir*(u.ori==0?1:-1),I=b(l[M==1?r:o]),L=I,C=[],D=[];for(let H=M==1?r:o;H>=r&&H<=o;H+=M)if(c[H]!=null){let Y=l[H],Q=b(Y);C.push(L=Q),D.push(v(c[H]))}let k={stroke:n(C,D,E,y,A,_),fill:null,clip:null,band:null,gaps:null,flags:Go},N=k.stroke,[B,W]=ip(i,s);if(a.fill!=null||B!=0){let H=k.fill=new Path2D(N),st=a.fillTo(i,s,a.min,a.max,B),Y=v(st);y(H,L,Y),y(H,I,Y)}if(!a.spanGaps){let H=[];H.push(...sp(l,c,r,o,M,b,e)),k.gaps=H=a.gaps(i,s,r,o,H),k.clip=Yu(H,u.ori,p,x,g,m)}return W!=0&&(k.band=W==2?[Rs(i,s,r,o,N,-1),Rs(i,s,r,o,N,1)]:Rs(i,s,r,o,N,W)),k})}function RR(n){return CR(PR,n)}function PR(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var Wf=new Set;function Jx(){for(let n of Wf)n.syncRect(!0)}Ho&&(Or(uC,Fo,Jx),Or(hC,Fo,Jx,!0),Or(Vu,Fo,()=>{ln.pxRatio=Ee}));var IR=U_(),LR=D_();function jx(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>$f(r,o,t,e))}function NR(n,t){return n.map((e,i)=>i==0?{}:xn({},t,e))}function $f(n,t,e,i){return xn({},t==0?e:i,n)}function k_(n,t,e){return t==null?zo:[t,e]}var DR=k_;function OR(n,t,e){return t==null?zo:Gu(t,e,Kf,!0)}function F_(n,t,e,i){return t==null?zo:$u(t,e,n.scales[i].log,!1)}var UR=F_;function B_(n,t,e,i){return t==null?zo:Zf(t,e,n.scales[i].log,!1)}var kR=B_;function FR(n,t,e,i,s){let r=jn(Px(n),Px(t)),o=t-n,a=Fi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?cr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Qx(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=wn((e=+s)*Ee))+"px"),[n,t,e]}function BR(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=ze(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ln(n,t,e){let i={mode:Me(n.mode,1)},s=i.mode;function r(w,R,U,F){let X=R.valToPct(w);return F+U*(R.dir==-1?1-X:X)}function o(w,R,U,F){let X=R.valToPct(w);return F+U*(R.dir==-1?X:1-X)}function a(w,R,U,F){return R.ori==0?r(w,R,U,F):o(w,R,U,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Mi(XT);if(n.id!=null&&(c.id=n.id),pi(c,n.class),n.title){let w=Mi(ZT,c);w.textContent=n.title}let u=ki("canvas"),h=i.ctx=u.getContext("2d"),d=Mi(KT,c);Or("click",d,w=>{w.target===p&&(He!=Wr||Ke!=$r)&&Dn.click(i,w)},!0);let f=i.under=Mi(JT,d);d.appendChild(u);let p=i.over=Mi(jT,d);n=Vo(n);let x=+Me(n.pxAlign,1),g=Zx(x);(n.plugins||[]).forEach(w=>{w.opts&&(n=w.opts(i,n)||n)});let m=n.ms||.001,_=i.series=s==1?jx(n.series||[],Gx,qx,!1):NR(n.series||[null],Xx),b=i.axes=jx(n.axes||[],Vx,Wx,!0),v=i.scales={},E=i.bands=n.bands||[];E.forEach(w=>{w.fill=ye(w.fill||null),w.dir=Me(w.dir,-1)});let A=s==2?_[1].facets[0].scale:_[0].scale,y={axes:ls,series:fe},M=(n.drawOrder||["axes","series"]).map(w=>y[w]);function I(w){let R=w.distr==3?U=>Cs(U>0?U:w.clamp(i,U,w.min,w.max,w.key)):w.distr==4?U=>Lf(U,w.asinh):w.distr==100?U=>w.fwd(U):U=>U;return U=>{let F=R(U),{_min:X,_max:J}=w,lt=J-X;return(F-X)/lt}}function L(w){let R=v[w];if(R==null){let U=(n.scales||ll)[w]||ll;if(U.from!=null){L(U.from);let F=xn({},v[U.from],U,{key:w});F.valToPct=I(F),v[w]=F}else{R=v[w]=xn({},w==A?T_:bR,U),R.key=w;let F=R.time,X=R.range,J=lr(X);if((w!=A||s==2&&!F)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Tx:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Tx:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&qu(X))){let lt=X;X=(pt,vt,Nt)=>vt==null?zo:Gu(vt,Nt,lt)}R.range=ye(X||(F?DR:w==A?R.distr==3?UR:R.distr==4?kR:k_:R.distr==3?F_:R.distr==4?B_:OR)),R.auto=ye(J?!1:R.auto),R.clamp=ye(R.clamp||vR),R._min=R._max=null,R.valToPct=I(R)}}}L("x"),L("y"),s==1&&_.forEach(w=>{L(w.scale)}),b.forEach(w=>{L(w.scale)});for(let w in n.scales)L(w);let C=v[A],D=C.distr,k,N;C.ori==0?(pi(c,qT),k=r,N=o):(pi(c,YT),k=o,N=r);let B={};for(let w in v){let R=v[w];(R.min!=null||R.max!=null)&&(B[w]={min:R.min,max:R.max},R.min=R.max=null)}let W=n.tzDate||(w=>new Date(wn(w/m))),H=n.fmtDate||Qf,st=m==1?qC(W):KC(W),Y=Fx(W,kx(m==1?XC:ZC,H)),Q=zx(W,Bx(jC,H)),it=[],ft=i.legend=xn({},eR,n.legend),dt=i.cursor=xn({},aR,{drag:{y:s==2}},n.cursor),tt=ft.show,ht=dt.show,gt=ft.markers;ft.idxs=it,gt.width=ye(gt.width),gt.dash=ye(gt.dash),gt.stroke=ye(gt.stroke),gt.fill=ye(gt.fill);let St,Mt,Ht,se=[],Vt=[],he,le=!1,ne={};if(ft.live){let w=_[1]?_[1].values:null;le=w!=null,he=le?w(i,1,0):{_:0};for(let R in he)ne[R]=qf}if(tt)if(St=ki("table",sC,c),Ht=ki("tbody",null,St),ft.mount(i,St),le){Mt=ki("thead",null,St,Ht);let w=ki("tr",null,Mt);ki("th",null,w);for(var Ze in he)ki("th",px,w).textContent=Ze}else pi(St,oC),ft.live&&pi(St,rC);let Ve={show:!0},cn={show:!1};function Ne(w,R){if(R==0&&(le||!ft.live||s==2))return zo;let U=[],F=ki("tr",aC,Ht,Ht.childNodes[R]);pi(F,w.class),w.show||pi(F,Dr);let X=ki("th",null,F);if(gt.show){let pt=Mi(lC,X);if(R>0){let vt=gt.width(i,R);vt&&(pt.style.border=vt+"px "+gt.dash(i,R)+" "+gt.stroke(i,R)),pt.style.background=gt.fill(i,R)}}let J=Mi(px,X);w.label instanceof HTMLElement?J.appendChild(w.label):J.textContent=w.label,R>0&&(gt.show||(J.style.color=w.width>0?gt.stroke(i,R):gt.fill(i,R)),ve("click",X,pt=>{if(dt._lock)return;Jt(pt);let vt=_.indexOf(w);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=_.some((Dt,Ut)=>Ut>0&&Ut!=vt&&Dt.show);_.forEach((Dt,Ut)=>{Ut>0&&Hi(Ut,Nt?Ut==vt?Ve:cn:Ve,!0,pn.setSeries)})}else Hi(vt,{show:!w.show},!0,pn.setSeries)},!1),jt&&ve(_x,X,pt=>{dt._lock||(Jt(pt),Hi(_.indexOf(w),qr,!0,pn.setSeries))},!1));for(var lt in he){let pt=ki("td",cC,F);pt.textContent="--",U.push(pt)}return[F,U]}let En=new Map;function ve(w,R,U,F=!0){let X=En.get(R)||{},J=dt.bind[w](i,R,U,F);J&&(Or(w,R,X[w]=J),En.set(R,X))}function _n(w,R,U){let F=En.get(R)||{};for(let X in F)(w==null||X==w)&&(Bf(X,R,F[X]),delete F[X]);w==null&&En.delete(R)}let je=0,un=0,G=0,Rt=0,Zt=0,re=0,wt=Zt,ke=re,zt=G,Xt=Rt,O=0,T=0,q=0,ut=0;i.bbox={};let at=!1,_t=!1,yt=!1,et=!1,rt=!1,mt=!1;function z(w,R,U){(U||w!=i.width||R!=i.height)&&ot(w,R),ce(!1),yt=!0,_t=!0,kn()}function ot(w,R){i.width=je=G=w,i.height=un=Rt=R,Zt=re=0,bt(),Gt();let U=i.bbox;O=U.left=Lr(Zt*Ee,.5),T=U.top=Lr(re*Ee,.5),q=U.width=Lr(G*Ee,.5),ut=U.height=Lr(Rt*Ee,.5)}let nt=3;function At(){let w=!1,R=0;for(;!w;){R++;let U=Vr(R),F=Gi(R);w=R==nt||U&&F,w||(ot(i.width,i.height),_t=!0)}}function xt({width:w,height:R}){z(w,R)}i.setSize=xt;function bt(){let w=!1,R=!1,U=!1,F=!1;b.forEach((X,J)=>{if(X.show&&X._show){let{side:lt,_size:pt}=X,vt=lt%2,Nt=X.label!=null?X.labelSize:0,Dt=pt+Nt;Dt>0&&(vt?(G-=Dt,lt==3?(Zt+=Dt,F=!0):U=!0):(Rt-=Dt,lt==0?(re+=Dt,w=!0):R=!0))}}),zi[0]=w,zi[1]=U,zi[2]=R,zi[3]=F,G-=Ai[1]+Ai[3],Zt+=Ai[3],Rt-=Ai[2]+Ai[0],re+=Ai[0]}function Gt(){let w=Zt+G,R=re+Rt,U=Zt,F=re;function X(J,lt){switch(J){case 1:return w+=lt,w-lt;case 2:return R+=lt,R-lt;case 3:return U-=lt,U+lt;case 0:return F-=lt,F+lt}}b.forEach((J,lt)=>{if(J.show&&J._show){let pt=J.side;J._pos=X(pt,J._size),J.label!=null&&(J._lpos=X(pt,J.labelSize))}})}if(dt.dataIdx==null){let w=dt.hover,R=w.skip=new Set(w.skip??[]);R.add(void 0);let U=w.prox=ye(w.prox),F=w.bias??=0;dt.dataIdx=(X,J,lt,pt)=>{if(J==0)return lt;let vt=lt,Nt=U(X,J,lt,pt)??Be,Dt=Nt>=0&&Nt<Be,Ut=C.ori==0?G:Rt,ie=dt.left,we=t[0],Se=t[J];if(R.has(Se[lt])){vt=null;let ge=null,Kt=null,Wt;if(F==0||F==-1)for(Wt=lt;ge==null&&Wt-- >0;)R.has(Se[Wt])||(ge=Wt);if(F==0||F==1)for(Wt=lt;Kt==null&&Wt++<Se.length;)R.has(Se[Wt])||(Kt=Wt);if(ge!=null||Kt!=null)if(Dt){let $e=ge==null?-1/0:k(we[ge],C,Ut,0),en=Kt==null?1/0:k(we[Kt],C,Ut,0),Pn=ie-$e,De=en-ie;Pn<=De?Pn<=Nt&&(vt=ge):De<=Nt&&(vt=Kt)}else vt=Kt==null?ge:ge==null?Kt:lt-ge<=Kt-lt?ge:Kt}else Dt&&An(ie-k(we[lt],C,Ut,0))>Nt&&(vt=null);return vt}}let Jt=w=>{dt.event=w};dt.idxs=it,dt._lock=!1;let ct=dt.points;ct.show=ye(ct.show),ct.size=ye(ct.size),ct.stroke=ye(ct.stroke),ct.width=ye(ct.width),ct.fill=ye(ct.fill);let kt=i.focus=xn({},n.focus||{alpha:.3},dt.focus),jt=kt.prox>=0,Ct=jt&&ct.one,oe=[],Ge=[],Gn=[];function Zo(w,R){let U=ct.show(i,R);if(U instanceof HTMLElement)return pi(U,iC),pi(U,w.class),is(U,-10,-10,G,Rt),p.insertBefore(U,oe[R]),U}function Fr(w,R){if(s==1||R>0){let U=s==1&&v[w.scale].time,F=w.value;w.value=U?Nx(F)?zx(W,Bx(F,H)):F||Q:F||xR,w.label=w.label||(U?cR:lR)}if(Ct||R>0){w.width=w.width==null?1:w.width,w.paths=w.paths||IR||bC,w.fillTo=ye(w.fillTo||SR),w.pxAlign=+Me(w.pxAlign,x),w.pxRound=Zx(w.pxAlign),w.stroke=ye(w.stroke||null),w.fill=ye(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let U=_R(jn(1,w.width),1),F=w.points=xn({},{size:U,width:jn(1,U*.2),stroke:w.stroke,space:U*2,paths:LR,_stroke:null,_fill:null},w.points);F.show=ye(F.show),F.filter=ye(F.filter),F.fill=ye(F.fill),F.stroke=ye(F.stroke),F.paths=ye(F.paths),F.pxAlign=w.pxAlign}if(tt){let U=Ne(w,R);se.splice(R,0,U[0]),Vt.splice(R,0,U[1]),ft.values.push(null)}if(ht){it.splice(R,0,null);let U=null;Ct?R==0&&(U=Zo(w,R)):R>0&&(U=Zo(w,R)),oe.splice(R,0,U),Ge.splice(R,0,0),Gn.splice(R,0,0)}Rn("addSeries",R)}function bh(w,R){R=R??_.length,w=s==1?$f(w,R,Gx,qx):$f(w,R,{},Xx),_.splice(R,0,w),Fr(_[R],R)}i.addSeries=bh;function hl(w){if(_.splice(w,1),tt){ft.values.splice(w,1),Vt.splice(w,1);let R=se.splice(w,1)[0];_n(null,R.firstChild),R.remove()}ht&&(it.splice(w,1),oe.splice(w,1)[0].remove(),Ge.splice(w,1),Gn.splice(w,1)),Rn("delSeries",w)}i.delSeries=hl;let zi=[!1,!1,!1,!1];function rs(w,R){if(w._show=w.show,w.show){let U=w.side%2,F=v[w.scale];F==null&&(w.scale=U?_[1].scale:A,F=v[w.scale]);let X=F.time;w.size=ye(w.size),w.space=ye(w.space),w.rotate=ye(w.rotate),lr(w.incrs)&&w.incrs.forEach(lt=>{!cr.has(lt)&&cr.set(lt,l_(lt))}),w.incrs=ye(w.incrs||(F.distr==2?HC:X?m==1?$C:YC:Nr)),w.splits=ye(w.splits||(X&&F.distr==1?st:F.distr==3?Vf:F.distr==4?dR:hR)),w.stroke=ye(w.stroke),w.grid.stroke=ye(w.grid.stroke),w.ticks.stroke=ye(w.ticks.stroke),w.border.stroke=ye(w.border.stroke);let J=w.values;w.values=lr(J)&&!lr(J[0])?ye(J):X?lr(J)?Fx(W,kx(J,H)):Nx(J)?JC(W,J):J||Y:J||uR,w.filter=ye(w.filter||(F.distr>=3&&F.log==10?mR:F.distr==3&&F.log==2?gR:o_)),w.font=Qx(w.font),w.labelFont=Qx(w.labelFont),w._size=w.size(i,null,R,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(zi[R]=!0,w._el=Mi(QT,d))}}function os(w,R,U,F){let[X,J,lt,pt]=U,vt=R%2,Nt=0;return vt==0&&(pt||J)&&(Nt=R==0&&!X||R==2&&!lt?wn(Vx.size/3):0),vt==1&&(X||lt)&&(Nt=R==1&&!J||R==3&&!pt?wn(Wx.size/2):0),Nt}let Ko=i.padding=(n.padding||[os,os,os,os]).map(w=>ye(Me(w,os))),Ai=i._padding=Ko.map((w,R)=>w(i,R,zi,0)),Qe,rn=null,on=null,Vi=s==1?_[0].idxs:null,ni=null,Ls=!1;function Jo(w,R){if(t=w??[],i.data=i._data=t,s==2){Qe=0;for(let U=1;U<_.length;U++)Qe+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ni=t[0],Qe=ni.length;let U=t;if(D==2){U=t.slice();let F=U[0]=Array(Qe);for(let X=0;X<Qe;X++)F[X]=X}i._data=t=U}if(ce(!0),Rn("setData"),D==2&&(yt=!0),R!==!1){let U=C;U.auto(i,Ls)?jo():Os(A,U.min,U.max),et=et||dt.left>=0,mt=!0,kn()}}i.setData=Jo;function jo(){Ls=!0;let w,R;s==1&&(Qe>0?(rn=Vi[0]=0,on=Vi[1]=Qe-1,w=t[0][rn],R=t[0][on],D==2?(w=rn,R=on):w==R&&(D==3?[w,R]=$u(w,w,C.log,!1):D==4?[w,R]=Zf(w,w,C.log,!1):C.time?R=w+wn(86400/m):[w,R]=Gu(w,R,Kf,!0))):(rn=Vi[0]=w=null,on=Vi[1]=R=null)),Os(A,w,R)}let Br,Ns,zr,P,$,j,Z,K,Et,Pt;function Tt(w,R,U,F,X,J){w??=gx,U??=jf,F??="butt",X??=gx,J??="round",w!=Br&&(h.strokeStyle=Br=w),X!=Ns&&(h.fillStyle=Ns=X),R!=zr&&(h.lineWidth=zr=R),J!=$&&(h.lineJoin=$=J),F!=j&&(h.lineCap=j=F),U!=P&&h.setLineDash(P=U)}function It(w,R,U,F){R!=Ns&&(h.fillStyle=Ns=R),w!=Z&&(h.font=Z=w),U!=K&&(h.textAlign=K=U),F!=Et&&(h.textBaseline=Et=F)}function Bt(w,R,U,F,X=0){if(F.length>0&&w.auto(i,Ls)&&(R==null||R.min==null)){let J=Me(rn,0),lt=Me(on,F.length-1),pt=U.min==null?mC(F,J,lt,X,w.distr==3):[U.min,U.max];w.min=Bi(w.min,U.min=pt[0]),w.max=jn(w.max,U.max=pt[1])}}let ee={min:null,max:null};function de(){for(let F in v){let X=v[F];B[F]==null&&(X.min==null||B[A]!=null&&X.auto(i,Ls))&&(B[F]=ee)}for(let F in v){let X=v[F];B[F]==null&&X.from!=null&&B[X.from]!=null&&(B[F]=ee)}B[A]!=null&&ce(!0);let w={};for(let F in B){let X=B[F];if(X!=null){let J=w[F]=Vo(v[F],wC);if(X.min!=null)xn(J,X);else if(F!=A||s==2)if(Qe==0&&J.from==null){let lt=J.range(i,null,null,F);J.min=lt[0],J.max=lt[1]}else J.min=Be,J.max=-Be}}if(Qe>0){_.forEach((F,X)=>{if(s==1){let J=F.scale,lt=B[J];if(lt==null)return;let pt=w[J];if(X==0){let vt=pt.range(i,pt.min,pt.max,J);pt.min=vt[0],pt.max=vt[1],rn=Fi(pt.min,t[0]),on=Fi(pt.max,t[0]),on-rn>1&&(t[0][rn]<pt.min&&rn++,t[0][on]>pt.max&&on--),F.min=ni[rn],F.max=ni[on]}else F.show&&F.auto&&Bt(pt,lt,F,t[X],F.sorted);F.idxs[0]=rn,F.idxs[1]=on}else if(X>0&&F.show&&F.auto){let[J,lt]=F.facets,pt=J.scale,vt=lt.scale,[Nt,Dt]=t[X],Ut=w[pt],ie=w[vt];Ut!=null&&Bt(Ut,B[pt],J,Nt,J.sorted),ie!=null&&Bt(ie,B[vt],lt,Dt,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in w){let X=w[F],J=B[F];if(X.from==null&&(J==null||J.min==null)){let lt=X.range(i,X.min==Be?null:X.min,X.max==-Be?null:X.max,F);X.min=lt[0],X.max=lt[1]}}}for(let F in w){let X=w[F];if(X.from!=null){let J=w[X.from];if(J.min==null)X.min=X.max=null;else{let lt=X.range(i,J.min,J.max,F);X.min=lt[0],X.max=lt[1]}}}let R={},U=!1;for(let F in w){let X=w[F],J=v[F];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let lt=J.distr;J._min=lt==3?Cs(J.min):lt==4?Lf(J.min,J.asinh):lt==100?J.fwd(J.min):J.min,J._max=lt==3?Cs(J.max):lt==4?Lf(J.max,J.asinh):lt==100?J.fwd(J.max):J.max,R[F]=U=!0}}if(U){_.forEach((F,X)=>{s==2?X>0&&R.y&&(F._paths=null):R[F.scale]&&(F._paths=null)});for(let F in R)yt=!0,Rn("setScale",F);ht&&dt.left>=0&&(et=mt=!0)}for(let F in B)B[F]=null}function Ft(w){let R=zf(rn-1,0,Qe-1),U=zf(on+1,0,Qe-1);for(;w[R]==null&&R>0;)R--;for(;w[U]==null&&U<Qe-1;)U++;return[R,U]}function fe(){if(Qe>0){let w=_.some(R=>R._focus)&&Pt!=kt.alpha;w&&(h.globalAlpha=Pt=kt.alpha),_.forEach((R,U)=>{if(U>0&&R.show&&(Je(U,!1),Je(U,!0),R._paths==null)){let F=Pt;Pt!=R.alpha&&(h.globalAlpha=Pt=R.alpha);let X=s==2?[0,t[U][0].length-1]:Ft(t[U]);R._paths=R.paths(i,U,X[0],X[1]),Pt!=F&&(h.globalAlpha=Pt=F)}}),_.forEach((R,U)=>{if(U>0&&R.show){let F=Pt;Pt!=R.alpha&&(h.globalAlpha=Pt=R.alpha),R._paths!=null&&Pe(U,!1);{let X=R._paths!=null?R._paths.gaps:null,J=R.points.show(i,U,rn,on,X),lt=R.points.filter(i,U,J,X);(J||lt)&&(R.points._paths=R.points.paths(i,U,rn,on,lt),Pe(U,!0))}Pt!=F&&(h.globalAlpha=Pt=F),Rn("drawSeries",U)}}),w&&(h.globalAlpha=Pt=1)}}function Je(w,R){let U=R?_[w].points:_[w];U._stroke=U.stroke(i,w),U._fill=U.fill(i,w)}function Pe(w,R){let U=R?_[w].points:_[w],{stroke:F,fill:X,clip:J,flags:lt,_stroke:pt=U._stroke,_fill:vt=U._fill,_width:Nt=U.width}=U._paths;Nt=ze(Nt*Ee,3);let Dt=null,Ut=Nt%2/2;R&&vt==null&&(vt=Nt>0?"#fff":pt);let ie=U.pxAlign==1&&Ut>0;if(ie&&h.translate(Ut,Ut),!R){let we=O-Nt/2,Se=T-Nt/2,ge=q+Nt,Kt=ut+Nt;Dt=new Path2D,Dt.rect(we,Se,ge,Kt)}R?Ot(pt,Nt,U.dash,U.cap,vt,F,X,lt,J):Ie(w,pt,Nt,U.dash,U.cap,vt,F,X,lt,Dt,J),ie&&h.translate(-Ut,-Ut)}function Ie(w,R,U,F,X,J,lt,pt,vt,Nt,Dt){let Ut=!1;vt!=0&&E.forEach((ie,we)=>{if(ie.series[0]==w){let Se=_[ie.series[1]],ge=t[ie.series[1]],Kt=(Se._paths||ll).band;lr(Kt)&&(Kt=ie.dir==1?Kt[0]:Kt[1]);let Wt,$e=null;Se.show&&Kt&&xC(ge,rn,on)?($e=ie.fill(i,we)||J,Wt=Se._paths.clip):Kt=null,Ot(R,U,F,X,$e,lt,pt,vt,Nt,Dt,Wt,Kt),Ut=!0}}),Ut||Ot(R,U,F,X,J,lt,pt,vt,Nt,Dt)}let yn=Go|Hf;function Ot(w,R,U,F,X,J,lt,pt,vt,Nt,Dt,Ut){Tt(w,R,U,F,X),(vt||Nt||Ut)&&(h.save(),vt&&h.clip(vt),Nt&&h.clip(Nt)),Ut?(pt&yn)==yn?(h.clip(Ut),Dt&&h.clip(Dt),xe(X,lt),hn(w,J,R)):pt&Hf?(xe(X,lt),h.clip(Ut),hn(w,J,R)):pt&Go&&(h.save(),h.clip(Ut),Dt&&h.clip(Dt),xe(X,lt),h.restore(),hn(w,J,R)):(xe(X,lt),hn(w,J,R)),(vt||Nt||Ut)&&h.restore()}function hn(w,R,U){U>0&&(R instanceof Map?R.forEach((F,X)=>{h.strokeStyle=Br=X,h.stroke(F)}):R!=null&&w&&h.stroke(R))}function xe(w,R){R instanceof Map?R.forEach((U,F)=>{h.fillStyle=Ns=F,h.fill(U)}):R!=null&&w&&h.fill(R)}function as(w,R,U,F){let X=b[w],J;if(F<=0)J=[0,0];else{let lt=X._space=X.space(i,w,R,U,F),pt=X._incrs=X.incrs(i,w,R,U,F,lt);J=FR(R,U,pt,F,lt)}return X._found=J}function dn(w,R,U,F,X,J,lt,pt,vt,Nt){let Dt=lt%2/2;x==1&&h.translate(Dt,Dt),Tt(pt,lt,vt,Nt,pt),h.beginPath();let Ut,ie,we,Se,ge=X+(F==0||F==3?-J:J);U==0?(ie=X,Se=ge):(Ut=X,we=ge);for(let Kt=0;Kt<w.length;Kt++)R[Kt]!=null&&(U==0?Ut=we=w[Kt]:ie=Se=w[Kt],h.moveTo(Ut,ie),h.lineTo(we,Se));h.stroke(),x==1&&h.translate(-Dt,-Dt)}function Vr(w){let R=!0;return b.forEach((U,F)=>{if(!U.show)return;let X=v[U.scale];if(X.min==null){U._show&&(R=!1,U._show=!1,ce(!1));return}else U._show||(R=!1,U._show=!0,ce(!1));let J=U.side,lt=J%2,{min:pt,max:vt}=X,[Nt,Dt]=as(F,pt,vt,lt==0?G:Rt);if(Dt==0)return;let Ut=X.distr==2,ie=U._splits=U.splits(i,F,pt,vt,Nt,Dt,Ut),we=X.distr==2?ie.map(Wt=>ni[Wt]):ie,Se=X.distr==2?ni[ie[1]]-ni[ie[0]]:Nt,ge=U._values=U.values(i,U.filter(i,we,F,Dt,Se),F,Dt,Se);U._rotate=J==2?U.rotate(i,ge,F,Dt):0;let Kt=U._size;U._size=wi(U.size(i,ge,F,w)),Kt!=null&&U._size!=Kt&&(R=!1)}),R}function Gi(w){let R=!0;return Ko.forEach((U,F)=>{let X=U(i,F,zi,w);X!=Ai[F]&&(R=!1),Ai[F]=X}),R}function ls(){for(let w=0;w<b.length;w++){let R=b[w];if(!R.show||!R._show)continue;let U=R.side,F=U%2,X,J,lt=R.stroke(i,w),pt=U==0||U==3?-1:1,[vt,Nt]=R._found;if(R.label!=null){let $n=R.labelGap*pt,ri=wn((R._lpos+$n)*Ee);It(R.labelFont[0],lt,"center",U==2?"top":mx),h.save(),F==1?(X=J=0,h.translate(ri,wn(T+ut/2)),h.rotate((U==3?-zu:zu)/2)):(X=wn(O+q/2),J=ri);let pr=s_(R.label)?R.label(i,w,vt,Nt):R.label;h.fillText(pr,X,J),h.restore()}if(Nt==0)continue;let Dt=v[R.scale],Ut=F==0?q:ut,ie=F==0?O:T,we=R._splits,Se=Dt.distr==2?we.map($n=>ni[$n]):we,ge=Dt.distr==2?ni[we[1]]-ni[we[0]]:vt,Kt=R.ticks,Wt=R.border,$e=Kt.show?Kt.size:0,en=wn($e*Ee),Pn=wn((R.alignTo==2?R._size-$e-R.gap:R.gap)*Ee),De=R._rotate*-zu/180,nn=g(R._pos*Ee),ii=(en+Pn)*pt,Wn=nn+ii;J=F==0?Wn:0,X=F==1?Wn:0;let xi=R.font[0],Ei=R.align==1?Uo:R.align==2?Rf:De>0?Uo:De<0?Rf:F==0?"center":U==3?Rf:Uo,$i=De||F==1?"middle":U==2?"top":mx;It(xi,lt,Ei,$i);let si=R.font[1]*R.lineGap,_i=we.map($n=>g(a($n,Dt,Ut,ie))),Ti=R._values;for(let $n=0;$n<Ti.length;$n++){let ri=Ti[$n];if(ri!=null){F==0?X=_i[$n]:J=_i[$n],ri=""+ri;let pr=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Xn=0;Xn<pr.length;Xn++){let Yp=pr[Xn];De?(h.save(),h.translate(X,J+Xn*si),h.rotate(De),h.fillText(Yp,0,0),h.restore()):h.fillText(Yp,X,J+Xn*si)}}}Kt.show&&dn(_i,Kt.filter(i,Se,w,Nt,ge),F,U,nn,en,ze(Kt.width*Ee,3),Kt.stroke(i,w),Kt.dash,Kt.cap);let Xi=R.grid;Xi.show&&dn(_i,Xi.filter(i,Se,w,Nt,ge),F,F==0?2:1,F==0?T:O,F==0?ut:q,ze(Xi.width*Ee,3),Xi.stroke(i,w),Xi.dash,Xi.cap),Wt.show&&dn([nn],[1],F==0?1:0,F==0?1:2,F==1?T:O,F==1?ut:q,ze(Wt.width*Ee,3),Wt.stroke(i,w),Wt.dash,Wt.cap)}Rn("drawAxes")}function ce(w){_.forEach((R,U)=>{U>0&&(R._paths=null,w&&(s==1?(R.min=null,R.max=null):R.facets.forEach(F=>{F.min=null,F.max=null})))})}let tn=!1,Hn=!1,Le=[];function fn(){Hn=!1;for(let w=0;w<Le.length;w++)Rn(...Le[w]);Le.length=0}function kn(){tn||(IC(Pp),tn=!0)}function dl(w,R=!1){tn=!0,Hn=R,w(i),Pp(),R&&Le.length>0&&queueMicrotask(fn)}i.batch=dl;function Pp(){if(at&&(de(),at=!1),yt&&(At(),yt=!1),_t){if(Ye(f,Uo,Zt),Ye(f,"top",re),Ye(f,sl,G),Ye(f,rl,Rt),Ye(p,Uo,Zt),Ye(p,"top",re),Ye(p,sl,G),Ye(p,rl,Rt),Ye(d,sl,je),Ye(d,rl,un),u.width=wn(je*Ee),u.height=wn(un*Ee),b.forEach(({_el:w,_show:R,_size:U,_pos:F,side:X})=>{if(w!=null)if(R){let J=X===3||X===0?U:0,lt=X%2==1;Ye(w,lt?"left":"top",F-J),Ye(w,lt?"width":"height",U),Ye(w,lt?"top":"left",lt?re:Zt),Ye(w,lt?"height":"width",lt?Rt:G),Ff(w,Dr)}else pi(w,Dr)}),Br=Ns=zr=$=j=Z=K=Et=P=null,Pt=1,ea(!0),Zt!=wt||re!=ke||G!=zt||Rt!=Xt){ce(!1);let w=G/zt,R=Rt/Xt;if(ht&&!et&&dt.left>=0){dt.left*=w,dt.top*=R,Gr&&is(Gr,wn(dt.left),0,G,Rt),Hr&&is(Hr,0,wn(dt.top),G,Rt);for(let U=0;U<oe.length;U++){let F=oe[U];F!=null&&(Ge[U]*=w,Gn[U]*=R,is(F,wi(Ge[U]),wi(Gn[U]),G,Rt))}}if(We.show&&!rt&&We.left>=0&&We.width>0){We.left*=w,We.width*=w,We.top*=R,We.height*=R;for(let U in Th)Ye(Xr,U,We[U])}wt=Zt,ke=re,zt=G,Xt=Rt}Rn("setSize"),_t=!1}je>0&&un>0&&(h.clearRect(0,0,u.width,u.height),Rn("drawClear"),M.forEach(w=>w()),Rn("draw")),We.show&&rt&&(fl(We),rt=!1),ht&&et&&(fr(null,!0,!1),et=!1),ft.show&&ft.live&&mt&&(Ah(),mt=!1),l||(l=!0,i.status=1,Rn("ready")),Ls=!1,tn=!1}i.redraw=(w,R)=>{yt=R||!1,w!==!1?Os(A,C.min,C.max):kn()};function Sh(w,R){let U=v[w];if(U.from==null){if(Qe==0){let F=U.range(i,R.min,R.max,w);R.min=F[0],R.max=F[1]}if(R.min>R.max){let F=R.min;R.min=R.max,R.max=F}if(Qe>1&&R.min!=null&&R.max!=null&&R.max-R.min<1e-16)return;w==A&&U.distr==2&&Qe>0&&(R.min=Fi(R.min,t[0]),R.max=Fi(R.max,t[0]),R.min==R.max&&R.max++),B[w]=R,at=!0,kn()}}i.setScale=Sh;let Mh,wh,Gr,Hr,Ip,Lp,Wr,$r,Np,Dp,He,Ke,Ds=!1,Dn=dt.drag,Tn=Dn.x,Cn=Dn.y;ht&&(dt.x&&(Mh=Mi(eC,p)),dt.y&&(wh=Mi(nC,p)),C.ori==0?(Gr=Mh,Hr=wh):(Gr=wh,Hr=Mh),He=dt.left,Ke=dt.top);let We=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Xr=We.show?Mi(tC,We.over?p:f):null;function fl(w,R){if(We.show){for(let U in w)We[U]=w[U],U in Th&&Ye(Xr,U,w[U]);R!==!1&&Rn("setSelect")}}i.setSelect=fl;function Ev(w){if(_[w].show)tt&&Ff(se[w],Dr);else if(tt&&pi(se[w],Dr),ht){let U=Ct?oe[0]:oe[w];U!=null&&is(U,-10,-10,G,Rt)}}function Os(w,R,U){Sh(w,{min:R,max:U})}function Hi(w,R,U,F){R.focus!=null&&Iv(w),R.show!=null&&_.forEach((X,J)=>{J>0&&(w==J||w==null)&&(X.show=R.show,Ev(J),s==2?(Os(X.facets[0].scale,null,null),Os(X.facets[1].scale,null,null)):Os(X.scale,null,null),kn())}),U!==!1&&Rn("setSeries",w,R),F&&na("setSeries",i,w,R)}i.setSeries=Hi;function Tv(w,R){xn(E[w],R)}function Cv(w,R){w.fill=ye(w.fill||null),w.dir=Me(w.dir,-1),R=R??E.length,E.splice(R,0,w)}function Rv(w){w==null?E.length=0:E.splice(w,1)}i.addBand=Cv,i.setBand=Tv,i.delBand=Rv;function Pv(w,R){_[w].alpha=R,ht&&oe[w]!=null&&(oe[w].style.opacity=R),tt&&se[w]&&(se[w].style.opacity=R)}let cs,Us,dr,qr={focus:!0};function Iv(w){if(w!=dr){let R=w==null,U=kt.alpha!=1;_.forEach((F,X)=>{if(s==1||X>0){let J=R||X==0||X==w;F._focus=R?null:J,U&&Pv(X,J?1:kt.alpha)}}),dr=w,U&&kn()}}tt&&jt&&ve(yx,St,w=>{dt._lock||(Jt(w),dr!=null&&Hi(null,qr,!0,pn.setSeries))});function Wi(w,R,U){let F=v[R];U&&(w=w/Ee-(F.ori==1?re:Zt));let X=G;F.ori==1&&(X=Rt,w=X-w),F.dir==-1&&(w=X-w);let J=F._min,lt=F._max,pt=w/X,vt=J+(lt-J)*pt,Nt=F.distr;return Nt==3?Bo(10,vt):Nt==4?yC(vt,F.asinh):Nt==100?F.bwd(vt):vt}function Lv(w,R){let U=Wi(w,A,R);return Fi(U,t[0],rn,on)}i.valToIdx=w=>Fi(w,t[0]),i.posToIdx=Lv,i.posToVal=Wi,i.valToPos=(w,R,U)=>v[R].ori==0?r(w,v[R],U?q:G,U?O:0):o(w,v[R],U?ut:Rt,U?T:0),i.setCursor=(w,R,U)=>{He=w.left,Ke=w.top,fr(null,R,U)};function Op(w,R){Ye(Xr,Uo,We.left=w),Ye(Xr,sl,We.width=R)}function Up(w,R){Ye(Xr,"top",We.top=w),Ye(Xr,rl,We.height=R)}let Qo=C.ori==0?Op:Up,ta=C.ori==1?Op:Up;function Nv(){if(tt&&ft.live)for(let w=s==2?1:0;w<_.length;w++){if(w==0&&le)continue;let R=ft.values[w],U=0;for(let F in R)Vt[w][U++].firstChild.nodeValue=R[F]}}function Ah(w,R){if(w!=null&&(w.idxs?w.idxs.forEach((U,F)=>{it[F]=U}):MC(w.idx)||it.fill(w.idx),ft.idx=it[0]),tt&&ft.live){for(let U=0;U<_.length;U++)(U>0||s==1&&!le)&&Dv(U,it[U]);Nv()}mt=!1,R!==!1&&Rn("setLegend")}i.setLegend=Ah;function Dv(w,R){let U=_[w],F=w==0&&D==2?ni:t[w],X;le?X=U.values(i,w,R)??ne:(X=U.value(i,R==null?null:F[R],w,R),X=X==null?ne:{_:X}),ft.values[w]=X}function fr(w,R,U){Np=He,Dp=Ke,[He,Ke]=dt.move(i,He,Ke),dt.left=He,dt.top=Ke,ht&&(Gr&&is(Gr,wn(He),0,G,Rt),Hr&&is(Hr,0,wn(Ke),G,Rt));let F,X=rn>on;cs=Be,Us=null;let J=C.ori==0?G:Rt,lt=C.ori==1?G:Rt;if(He<0||Qe==0||X){F=dt.idx=null;for(let pt=0;pt<_.length;pt++){let vt=oe[pt];vt!=null&&is(vt,-10,-10,G,Rt)}jt&&Hi(null,qr,!0,w==null&&pn.setSeries),ft.live&&(it.fill(F),mt=!0)}else{let pt,vt,Nt;s==1&&(pt=C.ori==0?He:Ke,vt=Wi(pt,A),F=dt.idx=Fi(vt,t[0],rn,on),Nt=k(t[0][F],C,J,0));let Dt=-10,Ut=-10,ie=0,we=0,Se=!0,ge="",Kt="";for(let Wt=s==2?1:0;Wt<_.length;Wt++){let $e=_[Wt],en=it[Wt],Pn=en==null?null:s==1?t[Wt][en]:t[Wt][1][en],De=dt.dataIdx(i,Wt,F,vt),nn=De==null?null:s==1?t[Wt][De]:t[Wt][1][De];if(mt=mt||nn!=Pn||De!=en,it[Wt]=De,Wt>0&&$e.show){let ii=De==null?-10:De==F?Nt:k(s==1?t[0][De]:t[Wt][0][De],C,J,0),Wn=nn==null?-10:N(nn,s==1?v[$e.scale]:v[$e.facets[1].scale],lt,0);if(jt&&nn!=null){let xi=C.ori==1?He:Ke,Ei=An(kt.dist(i,Wt,De,Wn,xi));if(Ei<cs){let $i=kt.bias;if($i!=0){let si=Wi(xi,$e.scale),_i=nn>=0?1:-1,Ti=si>=0?1:-1;Ti==_i&&(Ti==1?$i==1?nn>=si:nn<=si:$i==1?nn<=si:nn>=si)&&(cs=Ei,Us=Wt)}else cs=Ei,Us=Wt}}if(mt||Ct){let xi,Ei;C.ori==0?(xi=ii,Ei=Wn):(xi=Wn,Ei=ii);let $i,si,_i,Ti,Xi,$n,ri=!0,pr=ct.bbox;if(pr!=null){ri=!1;let Xn=pr(i,Wt);_i=Xn.left,Ti=Xn.top,$i=Xn.width,si=Xn.height}else _i=xi,Ti=Ei,$i=si=ct.size(i,Wt);if($n=ct.fill(i,Wt),Xi=ct.stroke(i,Wt),Ct)Wt==Us&&cs<=kt.prox&&(Dt=_i,Ut=Ti,ie=$i,we=si,Se=ri,ge=$n,Kt=Xi);else{let Xn=oe[Wt];Xn!=null&&(Ge[Wt]=_i,Gn[Wt]=Ti,Ex(Xn,$i,si,ri),wx(Xn,$n,Xi),is(Xn,wi(_i),wi(Ti),G,Rt))}}}}if(Ct){let Wt=kt.prox,$e=dr==null?cs<=Wt:cs>Wt||Us!=dr;if(mt||$e){let en=oe[0];en!=null&&(Ge[0]=Dt,Gn[0]=Ut,Ex(en,ie,we,Se),wx(en,ge,Kt),is(en,wi(Dt),wi(Ut),G,Rt))}}}if(We.show&&Ds)if(w!=null){let[pt,vt]=pn.scales,[Nt,Dt]=pn.match,[Ut,ie]=w.cursor.sync.scales,we=w.cursor.drag;if(Tn=we._x,Cn=we._y,Tn||Cn){let{left:Se,top:ge,width:Kt,height:Wt}=w.select,$e=w.scales[Ut].ori,en=w.posToVal,Pn,De,nn,ii,Wn,xi=pt!=null&&Nt(pt,Ut),Ei=vt!=null&&Dt(vt,ie);xi&&Tn?($e==0?(Pn=Se,De=Kt):(Pn=ge,De=Wt),nn=v[pt],ii=k(en(Pn,Ut),nn,J,0),Wn=k(en(Pn+De,Ut),nn,J,0),Qo(Bi(ii,Wn),An(Wn-ii))):Qo(0,J),Ei&&Cn?($e==1?(Pn=Se,De=Kt):(Pn=ge,De=Wt),nn=v[vt],ii=N(en(Pn,ie),nn,lt,0),Wn=N(en(Pn+De,ie),nn,lt,0),ta(Bi(ii,Wn),An(Wn-ii))):ta(0,lt)}else Ch()}else{let pt=An(Np-Ip),vt=An(Dp-Lp);if(C.ori==1){let ie=pt;pt=vt,vt=ie}Tn=Dn.x&&pt>=Dn.dist,Cn=Dn.y&&vt>=Dn.dist;let Nt=Dn.uni;Nt!=null?Tn&&Cn&&(Tn=pt>=Nt,Cn=vt>=Nt,!Tn&&!Cn&&(vt>pt?Cn=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||Cn)&&(Tn=Cn=!0);let Dt,Ut;Tn&&(C.ori==0?(Dt=Wr,Ut=He):(Dt=$r,Ut=Ke),Qo(Bi(Dt,Ut),An(Ut-Dt)),Cn||ta(0,lt)),Cn&&(C.ori==1?(Dt=Wr,Ut=He):(Dt=$r,Ut=Ke),ta(Bi(Dt,Ut),An(Ut-Dt)),Tn||Qo(0,J)),!Tn&&!Cn&&(Qo(0,0),ta(0,0))}if(Dn._x=Tn,Dn._y=Cn,w==null){if(U){if(qp!=null){let[pt,vt]=pn.scales;pn.values[0]=pt!=null?Wi(C.ori==0?He:Ke,pt):null,pn.values[1]=vt!=null?Wi(C.ori==1?He:Ke,vt):null}na(Pf,i,He,Ke,G,Rt,F)}if(jt){let pt=U&&pn.setSeries,vt=kt.prox;dr==null?cs<=vt&&Hi(Us,qr,!0,pt):cs>vt?Hi(null,qr,!0,pt):Us!=dr&&Hi(Us,qr,!0,pt)}}mt&&(ft.idx=F,Ah()),R!==!1&&Rn("setCursor")}let ks=null;Object.defineProperty(i,"rect",{get(){return ks==null&&ea(!1),ks}});function ea(w=!1){w?ks=null:(ks=p.getBoundingClientRect(),Rn("syncRect",ks))}function kp(w,R,U,F,X,J,lt){dt._lock||Ds&&w!=null&&w.movementX==0&&w.movementY==0||(Eh(w,R,U,F,X,J,lt,!1,w!=null),w!=null?fr(null,!0,!0):fr(R,!0,!1))}function Eh(w,R,U,F,X,J,lt,pt,vt){if(ks==null&&ea(!1),Jt(w),w!=null)U=w.clientX-ks.left,F=w.clientY-ks.top;else{if(U<0||F<0){He=-10,Ke=-10;return}let[Nt,Dt]=pn.scales,Ut=R.cursor.sync,[ie,we]=Ut.values,[Se,ge]=Ut.scales,[Kt,Wt]=pn.match,$e=R.axes[0].side%2==1,en=C.ori==0?G:Rt,Pn=C.ori==1?G:Rt,De=$e?J:X,nn=$e?X:J,ii=$e?F:U,Wn=$e?U:F;if(Se!=null?U=Kt(Nt,Se)?a(ie,v[Nt],en,0):-10:U=en*(ii/De),ge!=null?F=Wt(Dt,ge)?a(we,v[Dt],Pn,0):-10:F=Pn*(Wn/nn),C.ori==1){let xi=U;U=F,F=xi}}vt&&(R==null||R.cursor.event.type==Pf)&&((U<=1||U>=G-1)&&(U=Lr(U,G)),(F<=1||F>=Rt-1)&&(F=Lr(F,Rt))),pt?(Ip=U,Lp=F,[Wr,$r]=dt.move(i,U,F)):(He=U,Ke=F)}let Th={width:0,height:0,left:0,top:0};function Ch(){fl(Th,!1)}let Fp,Bp,zp,Vp;function Gp(w,R,U,F,X,J,lt){Ds=!0,Tn=Cn=Dn._x=Dn._y=!1,Eh(w,R,U,F,X,J,lt,!0,!1),w!=null&&(ve(If,Uf,Hp,!1),na(xx,i,Wr,$r,G,Rt,null));let{left:pt,top:vt,width:Nt,height:Dt}=We;Fp=pt,Bp=vt,zp=Nt,Vp=Dt}function Hp(w,R,U,F,X,J,lt){Ds=Dn._x=Dn._y=!1,Eh(w,R,U,F,X,J,lt,!1,!0);let{left:pt,top:vt,width:Nt,height:Dt}=We,Ut=Nt>0||Dt>0,ie=Fp!=pt||Bp!=vt||zp!=Nt||Vp!=Dt;if(Ut&&ie&&fl(We),Dn.setScale&&Ut&&ie){let we=pt,Se=Nt,ge=vt,Kt=Dt;if(C.ori==1&&(we=vt,Se=Dt,ge=pt,Kt=Nt),Tn&&Os(A,Wi(we,A),Wi(we+Se,A)),Cn)for(let Wt in v){let $e=v[Wt];Wt!=A&&$e.from==null&&$e.min!=Be&&Os(Wt,Wi(ge+Kt,Wt),Wi(ge,Wt))}Ch()}else dt.lock&&(dt._lock=!dt._lock,fr(R,!0,w!=null));w!=null&&(_n(If,Uf),na(If,i,He,Ke,G,Rt,null))}function Ov(w,R,U,F,X,J,lt){if(dt._lock)return;Jt(w);let pt=Ds;if(Ds){let vt=!0,Nt=!0,Dt=10,Ut,ie;C.ori==0?(Ut=Tn,ie=Cn):(Ut=Cn,ie=Tn),Ut&&ie&&(vt=He<=Dt||He>=G-Dt,Nt=Ke<=Dt||Ke>=Rt-Dt),Ut&&vt&&(He=He<Wr?0:G),ie&&Nt&&(Ke=Ke<$r?0:Rt),fr(null,!0,!0),Ds=!1}He=-10,Ke=-10,it.fill(null),fr(null,!0,!0),pt&&(Ds=pt)}function Wp(w,R,U,F,X,J,lt){dt._lock||(Jt(w),jo(),Ch(),w!=null&&na(vx,i,He,Ke,G,Rt,null))}function $p(){b.forEach(BR),z(i.width,i.height,!0)}Or(Vu,Fo,$p);let Yr={};Yr.mousedown=Gp,Yr.mousemove=kp,Yr.mouseup=Hp,Yr.dblclick=Wp,Yr.setSeries=(w,R,U,F)=>{let X=pn.match[2];U=X(i,R,U),U!=-1&&Hi(U,F,!0,!1)},ht&&(ve(xx,p,Gp),ve(Pf,p,kp),ve(_x,p,w=>{Jt(w),ea(!1)}),ve(yx,p,Ov),ve(vx,p,Wp),Wf.add(i),i.syncRect=ea);let pl=i.hooks=n.hooks||{};function Rn(w,R,U){Hn?Le.push([w,R,U]):w in pl&&pl[w].forEach(F=>{F.call(null,i,R,U)})}(n.plugins||[]).forEach(w=>{for(let R in w.hooks)pl[R]=(pl[R]||[]).concat(w.hooks[R])});let Xp=(w,R,U)=>U,pn=xn({key:null,setSeries:!1,filters:{pub:Ix,sub:Ix},scales:[A,_[1]?_[1].scale:null],match:[Lx,Lx,Xp],values:[null,null]},dt.sync);pn.match.length==2&&pn.match.push(Xp),dt.sync=pn;let qp=pn.key,Rh=C_(qp);function na(w,R,U,F,X,J,lt){pn.filters.pub(w,R,U,F,X,J,lt)&&Rh.pub(w,R,U,F,X,J,lt)}Rh.sub(i);function Uv(w,R,U,F,X,J,lt){pn.filters.sub(w,R,U,F,X,J,lt)&&Yr[w](null,R,U,F,X,J,lt)}i.pub=Uv;function kv(){Rh.unsub(i),Wf.delete(i),En.clear(),Bf(Vu,Fo,$p),c.remove(),St?.remove(),Rn("destroy")}i.destroy=kv;function Ph(){Rn("init",n,t),Jo(t||n.data,!1),B[A]?Sh(A,B[A]):jo(),rt=We.show&&(We.width>0||We.height>0),et=mt=!0,z(n.width,n.height)}return _.forEach(Fr),b.forEach(rs),e?e instanceof HTMLElement?(e.appendChild(c),Ph()):e(i,Ph):Ph(),i}ln.assign=xn;ln.fmtNum=Jf;ln.rangeNum=Gu;ln.rangeLog=$u;ln.rangeAsinh=Zf;ln.orient=kr;ln.pxRatio=Ee;ln.join=PC;ln.fmtDate=Qf,ln.tzDate=VC;ln.sync=C_;{ln.addGap=MR,ln.clipGaps=Yu;let n=ln.paths={points:D_};n.linear=U_,n.stepped=ER,n.bars=TR,n.spline=RR}var zR=20,[VR,z_,ju]=[46,14,4],V_=18,Qu=26,GR=16,th=12;function G_(n,{name:t,lines:e,word:i="",under:s=()=>[],over:r=()=>[],lookOf:o=Oi}){return s0(()=>{let a=n.data.slice(1).map((g,m)=>o(m)),[l,c]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],u=zR+n.axes[1]._size,h=u+l+z_,d=HR(i,e,a,u,h-z_),f=d.height+8,p=[...s(),...WR(n,l,c),{kind:"clip",x:0,y:0,width:l,height:c,shapes:$R(n,a)},{kind:"path",points:[[0,0],[0,c],[l,c]],stroke:me("--ink")},...r(),...XR(n,t,l,c,u)],x=f+c+VR;return{svg:Mu([...d.shapes,{kind:"moved",x:u,y:f,shapes:p}],h,x,t),width:h,height:x}})}function HR(n,t,e,i,s){let r=document.createElement("canvas").getContext("2d");r.font=`${th}px system-ui, sans-serif`;let o=[],[a,l]=[i,V_-4],c=me("--ink"),u=(h,d)=>{let f=d+r.measureText(h).width;a>i&&a+f>s&&([a,l]=[i,l+V_]);let p=a;return a+=f+GR,p};n&&o.push({kind:"text",x:u(n,0),y:l,text:n,size:th,fill:c});for(let[h,d]of t.entries()){let f=u(d,Qu),{colour:p,dash:x,area:g}=e[h];g?o.push({kind:"rect",x:f,y:l-9,width:Qu-6,height:9,fill:p}):o.push({kind:"path",points:[[f,l-4],[f+Qu-6,l-4]],stroke:p,lineWidth:1.6,dash:x}),o.push({kind:"text",x:f+Qu,y:l,text:d,size:th,fill:c})}return{shapes:o,height:o.length?l+4:0}}function eh(n,t,e){let{_splits:i,_values:s}=n.axes[t];return i.flatMap((r,o)=>s[o]?[[n.valToPos(r,e),s[o]]]:[])}function WR(n,t,e){let i=(...s)=>({kind:"path",points:s,stroke:me("--grid")});return[...eh(n,0,"x").map(([s])=>i([s,0],[s,e])),...eh(n,1,"y").map(([s])=>i([0,s],[t,s]))]}function $R(n,t){let[e,...i]=n.data;return i.map((s,r)=>{let{colour:o,dash:a,area:l}=t[r],c=[];for(let d=0;d<e.length;d++)s[d]===null||s[d]===void 0||Number.isNaN(s[d])||c.push([n.valToPos(e[d],"x"),n.valToPos(s[d],"y")]);if(!l||!c.length)return{kind:"path",points:c,stroke:o,lineWidth:1.6,dash:a};let u=n.valToPos(0,"y"),h=[c.at(-1),c[0]].map(([d])=>[d,u]);return{kind:"path",points:[...c,...h],fill:o,stroke:me("--page"),lineWidth:.5}})}function XR(n,t,e,i,s){let[r,o]=[me("--ink"),me("--ink")],a=(c,u,h,d)=>({kind:"text",x:c,y:u,text:h,size:th,fill:r,...d}),{label:l}=n.axes[0];return[...eh(n,0,"x").flatMap(([c,u])=>[{kind:"path",points:[[c,i],[c,i+ju]],stroke:o},a(c,i+ju+13,u,{anchor:"middle"})]),...eh(n,1,"y").flatMap(([c,u])=>[{kind:"path",points:[[0,c],[-ju,c]],stroke:o},a(-ju-4,c+4,u,{anchor:"end"})]),a(e/2,i+38,typeof l=="function"?l():l,{anchor:"middle"}),a(12-s,i/2,Oe(t),{anchor:"middle",turned:!0})]}var rh=210,qR=64,YR=.02,ZR=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...aP(3,20)];function ur(n,t,e,i){let s=t.map(o=>KR(o,e)),r=t.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>t[u].sharing===o.sharing).flat():null;return jR(o,s[a].map(c=>c.values),l,e,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function KR(n,t){return n.lines.map(e=>({clip:e.clip,values:e.readings?t[e.clip].line(e.readings,e.part):qe(e.values,Float32Array)}))}function JR(n,t,e){let i=[1/0,-1/0];for(let{clip:s,values:r}of n){let o=t[s].time;for(let a=0;a<o.length;a++){let l=o[a]-e.origins[s];l<e.start||l>e.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function nh(n){let[t,...e]=n.lines.map(i=>i.clip);return e.every(i=>i===t)?t??null:null}function jR(n,t,e,i,s){let{element:r,head:o,key:a,place:l}=op(n,n.owner),c=S("div",{className:"cursor"}),u=n.ball===void 0?null:S("div",{className:"ball"}),h=null,d=null,f=!1,p=[],x=new ResizeObserver(()=>h?.setSize({width:l.clientWidth,height:rh}));function g(){let{word:E}=n,A=W_(n).map((y,M)=>S("li",{},mr(ih(n,M)),y));a.replaceChildren(...E?[S("li",{},E)]:[],...A)}function m(){(s.span!==d||s.stretched!==f)&&(d=s.span,f=s.stretched,h.setData(H_(n,t,i,d),!1),h.setScale("x",{min:d.start,max:d.end}));let E=h.valToPos(s.time,"x").toFixed(2);c.style.transform=`translateX(${E}px)`,u&&(u.style.transform=`translate(${E}px, ${h.valToPos(_(),"y").toFixed(2)}px)`)}function _(){let{clip:E}=n.lines[n.ball];return nr(i[E].time,t[n.ball],s.clipTime(E))}function b(){d=s.span,f=s.stretched,h=new ln(eP(n,e,i,s,l.clientWidth),H_(n,t,i,d),l),h.setScale("x",{min:d.start,max:d.end}),h.over.append(c,...u?[u]:[]),oP(h,s),x.observe(l),h.hooks.setSize=[m];let E=()=>{g(),h.redraw(!1)};p=[s.onChange(m),tr(E)],g();let A=nh(n);o.append(ap(n,()=>h,{under:()=>X_(h,i,A,s.span),over:()=>q_(h,i,A,s.span)}))}function v(){for(let E of p)E();x.disconnect(),h.destroy()}return{element:r,start:b,dispose:v,get chart(){return h}}}function op(n,t=null){let e=t?`${Oe(t)}. ${n.text}`:n.text,i=S("div",{className:"chart",role:"img","aria-label":e}),s=S("ul",{className:"key"}),r=S("h2",{},`${Oe(n.title)} (${n.unit})`);t&&r.append(S("small",{},t));let o=S("div",{className:"head"},r);return{element:S("figure",{},o,s,i,S("figcaption",{},n.text)),head:o,key:s,place:i}}function W_({lines:n,word:t}){return n.map(({name:e})=>t?e.slice(t.length+1):e)}function ih({lines:n,stacked:t},e){let{area:i,look:s}=n[e];return i?{colour:i.startsWith("--")?me(i):i,dash:[],area:!0}:t?{colour:me("--ink"),dash:[]}:Oi(s??e)}function ap(n,t,{under:e,over:i}){let s=n.owner?`${n.title}, ${n.owner}`:n.title;return qi(s,()=>qn(s),()=>G_(t(),{name:`${n.title} (${n.unit})`,lines:W_(n),word:n.word,under:e,over:i,lookOf:n.stacked?o=>ih(n,o):void 0}))}function H_(n,t,e,i){if(n.stacked)return QR(n,t,e[n.lines[0].clip],i.origins[n.lines[0].clip]+i.start,i);let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return nh(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:ln.join(s)}function QR({lines:n},t,e,i,s){let r=n.map(({since:a},l)=>{let c=a===void 0?0:nr(e.time,t[a],i);return Float64Array.from(t[l],u=>u-c)}),o=new Float64Array(e.time.length);for(let a=n.length-1;a>=0;a--)if(n[a].area){for(let l=0;l<o.length;l++)o[l]+=r[a][l];r[a].set(o)}return[Float64Array.from(e.time,a=>a-s.origins[n[0].clip]),...r]}function tP(n){return n.lines.map(({area:t},e)=>({stroke:()=>t?me("--page"):ih(n,e).colour,...t?{fill:()=>ih(n,e).colour,fillTo:0}:{},width:t?.5:1.6,points:{show:!1}}))}function eP(n,t,e,i,s){let r=oh(),o=(a,l,c)=>sP(n,...t?JR(t,e,i.span):[l,c]);return{width:s,height:rh,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...n.stacked?tP(n):lp(n.lines)],axes:[{...r,...cp,labelFont:r.font,label:()=>`${i.span.label} (${ia(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?nP(a,i):iP(c,u,h),values:(a,l)=>l.map(c=>c===null?"":$_(c*ia(i.span).factor)),space:56},up(n)],hooks:{drawClear:[a=>sh(a,X_(a,e,nh(n),i.span))],draw:[a=>sh(a,q_(a,e,nh(n),i.span))]}}}function nP(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/qR)),{factor:i}=ia(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function iP(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function lp(n){return n.map(({look:t},e)=>({stroke:()=>Oi(t??e).colour,dash:Oi(t??e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var cp={size:24,gap:3,labelSize:18,labelGap:0};function oh(){return{stroke:()=>me("--muted"),grid:{stroke:()=>me("--grid"),width:1},ticks:{stroke:()=>me("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function up(n){return{...oh(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":$_(i)),...n.unit==="deg"?{incrs:ZR,space:26}:{space:30}}}function sP(n,t,e){let[i,s]=rP(t,e)?[t,e]:[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i!==0?i-r:i,s+2*r]}function rP(n,t){let e=Math.max(Math.abs(n),Math.abs(t));return n*t>0&&Math.min(Math.abs(n),Math.abs(t))>e/2&&t-n>YR*e}function $_(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?be(n):t.replace("-","−")}function sh(n,t){let{ctx:e,bbox:i}=n;Ja(e,t,devicePixelRatio,[i.left/devicePixelRatio,i.top/devicePixelRatio])}function X_(n,t,e,i){if(e===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return t[e].stages.filter(o=>o.driven).map(o=>{let[a,l]=[o.start,o.end].map(c=>Math.min(s,Math.max(0,n.valToPos(c-i.origins[e],"x"))));return{kind:"rect",x:a,y:0,width:l-a,height:r,fill:me("--band")}})}function q_(n,t,e,i){if(e===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return t[e].marks.flatMap(o=>{let a=n.valToPos(o.time-i.origins[e],"x");if(a<-1||a>s+1)return[];let l=a>s-16?-1:1;return[{kind:"path",points:[[a,0],[a,r]],stroke:me("--muted"),dash:[2,3]},{kind:"rect",x:a+(l>0?2:-14),y:1,width:12,height:15,fill:me("--page")},{kind:"text",x:a+l*8,y:13,text:o.letter,anchor:"middle",bold:!0,fill:me("--ink")}]})}function oP(n,t){hp(n,e=>{t.pause(),t.seek(n.posToVal(e.clientX-n.over.getBoundingClientRect().left,"x"))})}function hp(n,t){n.over.addEventListener("pointerdown",e=>{e.button===0&&(n.over.setPointerCapture(e.pointerId),t(e))}),n.over.addEventListener("pointermove",e=>{n.over.hasPointerCapture(e.pointerId)&&t(e)})}function aP(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function ah(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function Y_(n){let t=n.clips.map(Jn),e=Ui(t,n.spans),i=or(document.getElementById("player"),t,e,n);dp(i.stage.cells,t,e,n.energy);let s=ur(document.getElementById("plots"),n.plots,t,e);return ah(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function dp(n,t,e,i){let s=t.map((r,o)=>{let a=S("span",{className:"state-now"}),l=S("b",{},mr(Oi(o)),r.name);return tr(()=>l.replaceChild(mr(Oi(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(lP(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(Ts,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${be(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function lP(n,t){let e=s=>t==="deg"?`${On(s,0)}°`:`${be(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}function fp(n){return n.energy?Po:i0}function Z_(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}function Xo({sign:n,pattern:t}){return S("span",{className:`what ${t}`,"aria-hidden":"true"},S("span",{},n))}function lh(n,t){let e=n.scaleOf(t);if(!e)return[];let i=S("span",{className:"bar","aria-hidden":"true"});return i.style.background=fp(t).gradient,[S("p",{className:"scale"},`${t.title} (${t.unit})`,S("span",{className:"whole"},e.text(e.low),i,e.text(e.high)))]}function ch(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(h=>h.values.length),o=new Map;for(let h of t)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return e.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(h.shares?i.filter(_=>_.group===h.group):[h]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!f.length)return null;let[p,x]=[f.reduce((_,b)=>Math.min(_,b)),f.reduce((_,b)=>Math.max(_,b))],g=_=>x>p?(_-p)/(x-p):.5,m=cP((h.values??[]).filter(_=>_!==null));return{low:p,high:x,colour:_=>Z_(fp(h),g(_)),text:_=>ss(Number(_.toFixed(m)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&!h.tried),columns:e,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:t.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(e[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${ss(f)} ${h.unit}`}}}function cP(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function ss(n){let t=Number(n.toPrecision(3));return(t!==0&&Math.abs(t)<.001?t.toExponential():String(t)).replaceAll("-","−")}var uP="http://www.w3.org/2000/svg";function Te(n,t,...e){let i=document.createElementNS(uP,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}function qo({values:n,log:t},e=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...e].filter(d=>typeof d=="number"),r=t&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?hP:K_)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function pp(n,t,e,i,s=[]){let r=t.unit?`${t.name} (${t.unit})`:t.name,o=qo({values:n,log:t.log},s),a=.04*(i-e),l=u=>e+a+o.share(u)*(i-e-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?ss(u):u]);return{label:r,from:e,to:i,ticks:c,at:l,place:u=>n[u]===null?e+.75*a:l(n[u])}}function K_(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function hP(n,t){if(!(t>n))return[n];let e=t/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(t));s++)for(let r of e){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=t*(1+1e-9)&&i.push(o)}return i.length>1?i:K_(n,t)}function J_(n,t,e){let i=[Te("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],s=(r,o)=>i.push(Te("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:t.from+18,"text-anchor":"middle"});for(let[r,o]of t.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:e-8,"text-anchor":"middle"}),s(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var uh=300,j_=30,dP=92,ey=16,fP=5;function ny(n,t,{best:e,best_word:i,front:s},r){let a={axes:[...new Set(t.map(n.indexOf).filter(y=>y>=0))],opened:null,hovered:null,best:e,bestWord:i,front:s},l=S("div",{className:"titles"}),c=S("div",{className:"drawn"}),u=S("div",{className:"board"},l,c),h=S("div",{className:"scroll"},u),d=S("p",{className:"note",role:"status"}),f=S("p",{className:"note under"}," "),p=S("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let x=()=>{gP(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),hh(n,a,c)},g="Press a line to open its run. Move the two handles of an axis to select a range of values.",m=mP(n,a),_=`All ${n.study.noun}s as lines`,b=qi(_,()=>qn(_),()=>rr([u,m],_,".handle")),v=S("div",{className:"head"},S("h2",{},_),b),E=S("section",{className:"lines"},v,S("p",{className:"note"},g),pP(n,a,x),h,m,S("div",{className:"choices"},p,d),f);bP(n,a,c,f,r),n.whenAsked(()=>{hh(n,a,c),iy(n,a,c),Q_(n,d,p)}),Q_(n,d,p);let A=0;return new ResizeObserver(()=>{h.clientWidth!==A&&(A=h.clientWidth,x())}).observe(h),{element:E,show(y){a.opened=y,hh(n,a,c)}}}function Q_(n,t,e){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;t.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,e.hidden=n.asked.size===0}function pP(n,t,e){let i=n.columns.map((s,r)=>{let o=S("input",{type:"checkbox",checked:t.axes.includes(r)});return o.addEventListener("change",()=>{t.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:t.axes.includes(a)),o.checked||n.ask(r,0,1),e()}),S("label",{},o,s.name)});return S("details",{},S("summary",{},"Axes"),S("fieldset",{className:"filter"},S("legend",{},"Show an axis of"),...i))}function mP(n,t){let e=(r,o)=>S("li",{},S("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(e("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(e("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),t.front.length&&s.push(e("front","Pareto front")),t.best!==null&&s.push(e("best",t.bestWord)),s.push(e("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(S("li",{},S("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),S("ul",{className:"keys-of-lines"},...s)}function gP(n,t,{board:e,titles:i,place:s,width:r}){let o=t.axes.length,a=Math.max(r,o*dP);e.style.width=`${a}px`,i.replaceChildren(...t.axes.map(c=>xP(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,t.x=c=>(c+.5)*a/o,t.y=c=>uh-j_-c*(uh-2*j_);let l=Te("svg",{width:a,height:uh,viewBox:`0 0 ${a} ${uh}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Te("g",{class:"layers"}));for(let[c,u]of t.axes.entries())l.append(..._P(n.columns[u],t.x(c),t.y));s.replaceChildren(l),iy(n,t,s)}function xP(n){let t=n.unit?` (${n.unit})`:"",e=n.aim?S("small",{},`${n.aim} is best`):"";return S("div",{},`${n.name}${t}`,e)}function _P({scale:n,limits:t},e,i){let s=[Te("path",{class:"axis",d:`M${e} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of t){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Te("path",{class:"bound",d:`M${e} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Te("path",{class:"axis",d:`M${e} ${o}h5`}),Te("text",{class:"label",x:e+8,y:o,dy:"0.35em"},typeof r=="number"?ss(r):r))}return s}function iy(n,t,e){let i=e.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of e.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of t.axes.entries())for(let o of["least","most"]){let a=yP(n,t,e,r,o);a.style.left=`${t.x(s)}px`,e.append(a),a.dataset.handle===i&&a.focus()}}function yP(n,t,e,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${ss(c)} ${r.unit}`.trim():String(c??""),h=S("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${t.y(l)}px`;let d=x=>{let[g,m]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(x,0),m),m):n.ask(i,g,Math.max(Math.min(x,1),g))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",x=>{if(!(x.ctrlKey||x.metaKey||x.altKey)){if(x.key in p)d(l+p[x.key]);else if(x.key==="Home")d(0);else if(x.key==="End")d(1);else return;x.preventDefault()}}),h.addEventListener("pointerdown",x=>{x.preventDefault(),h.focus(),sy(x,g=>d(mp(t,e,g)))}),h}function sy(n,t,e=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(t),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),e(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function mp(n,t,e){let i=e.clientY-t.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function vP(n,t,e){let i="",s=!1;for(let[r,o]of t.axes.entries()){let a=n.columns[o].values[e];a!==null&&(i+=`${s?"L":"M"}${t.x(r).toFixed(1)} ${t.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function hh(n,t,e){let i=e.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:t.front.filter(n.shown),best:a(t.best),opened:a(t.opened),hovered:a(t.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>Te("path",{class:`line ${u}`,d:h.map(d=>vP(n,t,d)).join("")})))}function bP(n,t,e,i,s){let r=o=>{o!==t.hovered&&(t.hovered=o,e.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,hh(n,t,e))};e.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(ty(n,t,e,o))}),e.addEventListener("pointerleave",()=>r(null)),e.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:SP(t,e,o),l=mp(t,e,o),c=!1;sy(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>fP;let d=mp(t,e,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:ty(n,t,e,h);d!==null&&s(d)})})}function SP(n,t,e){let i=e.clientX-t.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<ey);return s<0?null:n.axes[s]}function ty(n,t,e,i){let s=e.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=t.axes.findLastIndex((p,x)=>t.x(x)<=r),[l,c]=[Math.max(0,a),Math.min(t.axes.length-1,a+1)],u=c>l?(r-t.x(l))/(t.x(c)-t.x(l)):0,h=(p,x)=>{let g=n.columns[t.axes[p]],m=g.values[x];return m===null?NaN:t.y(g.scale.share(m))},[d,f]=[null,ey];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[x,g]=[h(l,p),h(c,p)],m=x+u*(g-x),_=c>l?(g-x)/(t.x(c)-t.x(l)):0,b=Math.abs(o-m)/Math.hypot(1,_)-(n.good(p)?1:0);b<f&&([d,f]=[p,b])}return d}function ry(n,t){let e=ch(n,t),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=e.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:qo(c,MP(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...e,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>e.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function MP({limits:n,values:t}){let e=t.filter(r=>typeof r=="number"),[i,s]=[Math.min(...e),Math.max(...e)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var wP=12,[gp,Ps]=[200,76],ul=130;function ly(n,{marginals:t,pairs:e},i){let s=S("div",{className:"marginals"}),r=S("div",{className:"pairs"}),[o,a]=[t,e].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>TP(n,h))),r.replaceChildren(...CP(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[oy("Single unknowns",s),S("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&u.push(oy("Pairs of unknowns",r),S("p",{className:"note"},"Press a pair to enlarge it."),r),{element:S("section",{className:"agreeing"},...u)}}function oy(n,t){let e=qi(n,()=>qn(n),()=>rr([t],n));return S("div",{className:"head"},S("h2",{},n),e)}var AP=n=>Array.from({length:n.study.points},(t,e)=>e),cy=n=>AP(n).filter(t=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[t]).pattern));function EP(n,t,e){let i=t.words.length||wP,s=new Array(i).fill(0);for(let r of e)s[Math.min(i-1,Math.floor(t.share(n.values[r])*i))]+=1/e.length;return s}function TP(n,t){let e=n.columns[t],i=qo(e),s=cy(n),r=s.filter(g=>n.good(g)&&n.shown(g)),[o,a]=[s,r].map(g=>EP(e,i,g)),l=Math.max(...o,...r.length?a:[0]),c=gp/o.length,u=(g,m)=>Te("path",{class:m,d:g.map((_,b)=>`M${b*c+1} ${Ps}v${-_/l*(Ps-4)}h${c-2}V${Ps}z`).join("")}),h=g=>Te("path",{class:"agree",d:`M0 ${Ps}${g.map((m,_)=>`V${Ps-m/l*(Ps-4)}H${(_+1)*c}`).join("")}V${Ps}`}),d=`${e.name}: ${ay(e,i,r)}`,f=Te("svg",{viewBox:`0 0 ${gp} ${Ps}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],Te("path",{class:"axis",d:`M0 ${Ps}H${gp}`})),p=i.words.length?i.words:[0,1].map(g=>ss(i.value(g))),x=e.unit?` (${e.unit})`:"";return S("figure",{},S("figcaption",{},`${e.name}${x}`),f,S("div",{className:"ends"},...p.map(g=>S("span",{},g))),S("small",{},ay(e,i,r)))}function ay(n,t,e){if(!e.length)return"no sample agrees";if(t.words.length)return t.words.map(r=>`${Math.round(100*e.filter(o=>n.values[o]===r).length/e.length)} % ${r}`).join(", ");let i=e.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>ss(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function CP(n,t,e){return t.slice(1).flatMap((i,s)=>t.slice(0,-1).map((r,o)=>o>s?S("span",{}):RP(n,r,i,e)))}function RP(n,t,e,i){let[s,r]=[t,e].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>qo(f)),l=(f,p)=>Te("path",{class:p,d:f.map(x=>`M${(4+o.share(s.values[x])*(ul-8)).toFixed(1)} ${(ul-4-a.share(r.values[x])*(ul-8)).toFixed(1)}h0`).join("")}),c=cy(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=Te("svg",{viewBox:`0 0 ${ul} ${ul}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=S("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,S("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(t,e)),d}var[uy,xp]=[600,420],dh={left:76,right:14,top:12,bottom:52},hy=60,dy={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function fh(n,t,e){let{columns:i,study:s}=n,{quantity:r}=t,o=Array.from({length:s.points},(m,_)=>_),a=n.scaleOf(r),l=pp(i[t.x].values,i[t.x],dh.left,uy-dh.right,t.cells?.across),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,u=t.y===null?{name:r.title,unit:r.unit}:i[t.y],h=pp(c,u,xp-dh.bottom,dh.top,t.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Te("svg",{viewBox:`0 0 ${uy} ${xp}`,class:["scatter",o.length>hy&&"many",t.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});t.cells&&f.append(...LP(t.cells,l,h)),_p(s,t)&&f.append(...NP(s.boundaries,t,l,h)),f.append(...J_(l,h,xp),...py(i[t.x],l,h,!0),...t.y===null?[]:py(i[t.y],h,l,!1));let p=o.map(m=>[l.place(m),h.place(m)]);t.joined&&f.append(DP(t.front,p,i[t.x].aim));let x=o.length>hy?6:8,g=o.map(m=>IP(n,t,a,m,p[m],x));return f.append(...(t.ordered?PP(n,t,o):o).map(m=>g[m])),(g[t.current??0]??g[0])?.setAttribute("tabindex","0"),OP(f,g,t.ordered?[...o].sort((m,_)=>p[m][0]-p[_][0]):o,e),{element:S("div",{className:"scroll"},f),points:o}}function PP(n,t,e){let i=s=>(n.shown(s)?0:1e6)+(t.best===s?-1:n.study.verdicts[s]);return[...e].sort((s,r)=>i(r)-i(s))}function IP(n,t,e,i,[s,r],o){let{quantity:a}=t,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=Te("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Te("title",{},c)),{sign:h,pattern:d}=l===null?n.word(a.reasons[i]):{};return h&&u.setAttribute("class",`what ${d}`),n.shown(i)||u.classList.add("out"),t.front?.includes(i)&&u.append(Te("circle",{r:o+3,class:"front"})),u.append(Te("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":e.colour(l).face})),h&&u.append(Te("text",{"text-anchor":"middle",dy:"0.36em"},h)),t.best===i&&u.append(Te("text",{class:"best","text-anchor":"middle",dy:-o-6},t.bestWord)),u}function LP(n,t,e){let[i,s]=[fy(n.across.map(t.at)),fy(n.upwards.map(e.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Te("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function _p({boundaries:n},{x:t,y:e}){return!!n&&[t,e].every(i=>[n.x,n.y].includes(i))}function NP({cells:n,lines:t,x:e,y:i},s,r,o){let a=(h,d)=>i===null?[r.at(h),o.from+d*(o.to-o.from)]:s.x===e?[r.at(h),o.at(d)]:[r.at(d),o.at(h)],l=(h,d)=>`M${h.map(([f,p])=>`${f.toFixed(1)} ${p.toFixed(1)}`).join("L")}${d}`,c=n.map(([h,d,f,p])=>l([a(h,d),a(f,d),a(f,p),a(h,p)],"Z")),u=t.map(([h,d,f,p])=>l([a(h,d),a(f,p)],""));return[Te("path",{class:"cell-outline",d:c.join("")}),Te("path",{class:"boundary",d:u.join("")})]}function fy(n){let t=n.slice(1).map((s,r)=>(s+n[r])/2),[e,i]=[n[0],n.at(-1)];return[e,...t,i]}function py(n,t,e,i){let s=(a,l)=>Te("path",{class:l,d:i?`M${a} ${e.from}V${e.to}`:`M${e.from} ${a}H${e.to}`}),r=a=>a>=Math.min(t.from,t.to)&&a<=Math.max(t.from,t.to),o=[];typeof n.own=="number"&&r(t.at(n.own))&&o.push(s(t.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=t.at(l);if(!r(c))continue;let u=a===">="?t.from:t.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:e.to,height:e.from-e.to}:{y:h,height:d,x:e.from,width:e.to-e.from};o.push(Te("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function DP(n,t,e){let i=n.map(r=>t[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>e==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Te("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function OP(n,t,e,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of t)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in dy)t[e[e.indexOf(a)+dy[r.key]]]?.focus();else return;r.preventDefault()})}function my(n,{plane:t,front:e,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[t.x,t.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:e,best:i,bestWord:s,ordered:!0},f=S("div",{className:"map-place"}),p=S("div",{className:"map-legend"}),x=()=>{let C=d.x===u&&d.y===h;d.cells=C?t.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let D=fh(n,d,g);f.replaceChildren(D.element),p.replaceChildren(...UP(n,d))},g=C=>{m(C),o(C)};function m(C){d.current=d.opened=C;let D=f.contains(document.activeElement);x(),D&&f.querySelector(`[data-point="${C}"]`)?.focus()}let _=n.columns.map((C,D)=>[D,C.name]),b={across:v("across",_,()=>d.x,C=>A("x","y",C)),upwards:v("upwards",_,()=>d.y,C=>A("y","x",C)),show:v("show",a.map((C,D)=>[D,C.title]),()=>a.indexOf(d.quantity),C=>{d.quantity=a[C]})};function v(C,D,k,N){let B=S("select",{},...D.map(([H,st])=>S("option",{value:String(H)},st)));B.value=String(k()),B.addEventListener("change",()=>{N(Number(B.value)),E(),x()});let W=S("label",{},`${C} `,B);return W.dataset.name=C,{element:W,fill:()=>{B.value=String(k())}}}let E=()=>Object.values(b).forEach(C=>C.fill());function A(C,D,k){d[D]===k&&(d[D]=d[C]),d[C]=k}let y=()=>[d.y,d.x].map(C=>n.columns[C].name).join(" over "),M=qi(t.title,()=>qn(y()),()=>rr([f,p],y())),I=S("div",{className:"head"},S("h2",{},t.title),M),L=S("section",{className:"map"},I,S("div",{className:"choices"},...Object.values(b).map(C=>C.element)),f,p);return n.whenAsked(x),x(),{element:L,show:m,over(C,D){[d.x,d.y]=[C,D],E(),x()}}}function UP(n,{quantity:t,front:e,cells:i,x:s,y:r}){let o=lh(n,t),a=t.values?t.reasons:n.study.verdicts,l=n.study.words.flatMap((u,h)=>{let d=a.filter((f,p)=>f===h&&n.shown(p)).length;return d?[S("li",{},Xo(u),`${u.word} (${d})`)]:[]});e.length&&l.push(S("li",{},S("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(u=>n.columns[u]);if(c.some(u=>typeof u.own=="number")&&l.push(S("li",{},S("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(u=>u.limits.length)&&l.push(S("li",{},S("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])l.push(S("li",{},S("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} if only these two deviate`));return l.length&&o.push(S("ul",{},...l)),o}var kP=2e4,FP=16,BP=16,zP=12,gy={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function yy(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(_=>n.sizes[_]>1),[r,o]=s.length>1?s:VP(n.study.factors[s[0]])?[s[0],null]:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=S("div",{className:"map-place"}),c=S("div",{className:"map-legend"}),u=S("p",{className:"note"}),h=()=>{let _=a.y===null&&a.quantity.values&&n.sizes.every((v,E)=>v===1||E===a.x),b=i||_?fh(n,a,d):WP(n,a,d);l.replaceChildren(b.element),c.replaceChildren(...qP(n,a.quantity,b.points),..._p(n.study,a)?[YP(n.study.boundaries)]:[]),u.textContent=ZP(n,a.quantity,b.points)},d=_=>{a.current=a.opened=_,GP(l,_),t(_,a.quantity)},f=HP(n,a,s,h),x=qi("the map",()=>qn(a.quantity.title),()=>rr([l,c],by(n,a).split(";")[0])),g=S("div",{className:"head"},S("h2",{},"Map"),x),m=S("section",{className:"map"},g,f.element,l,c,u);return h(),{element:m,show(_){a.current=a.opened=_,i||(a.fixed=n.placesOf(_)),f.fill(),h()}}}function VP(n){return n?.values.some(t=>typeof t=="string"&&t.length>zP)??!1}function GP(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function HP(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=S("div",{className:"choices"}),l=(h,d,f,p)=>{let x=S("select",{},...d.map(([g,m])=>S("option",{value:String(g)},m)));return x.value=String(f),x.addEventListener("change",()=>{p(Number(x.value)),u(),i(),[...a.querySelectorAll("label")].find(g=>g.dataset.name===h)?.querySelector("select").focus()}),S("label",{},`${h} `,x)},c=(h,d)=>f=>{t[d]===f&&(t[d]=t[h]),t[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(t.quantity),d=>{t.quantity=r[d]})];if(e.length>2){let d=e.map(f=>[f,s[f].name]);h.push(l("across",d,t.x,c("x","y")),l("upwards",d,t.y,c("y","x")))}for(let d of e.filter(f=>!o&&f!==t.x&&f!==t.y)){let f=s[d].texts.map((p,x)=>[x,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,t.fixed[d],p=>{t.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function WP(n,t,e){let{factors:i}=n.study,[s,r]=[t.x,t.y].map(m=>m===null?1:n.sizes[m]),o=t.x===null;if(s*r>kP)return{element:S("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let a=n.scaleOf(t.quantity),l=s<=FP,c=(m,_)=>n.pointAt(t.fixed.map((b,v)=>v===t.x?m:v===t.y?_:b)),u=new Map,h=[],d=[];for(let m=0;m<r;m++){let _=o?m:r-1-m,b=t.y===null?"":o?i[t.y].texts[_]:_y(i[t.y],_),v=S("tr",{},S("th",{scope:"row"},b));for(let E=0;E<s;E++){let A=c(E,_),y=S("td",{tabIndex:-1,role:"gridcell"});$P(y,n,t,a,A,l),u.set(`${E} ${_}`,y),d.push(A),v.append(y)}h.push(v)}if(!o){let m=i[t.x].texts.map((_,b)=>S("th",{scope:"col"},_y(i[t.x],b)));h.push(S("tr",{className:"feet"},S("td"),...m))}let f=S("table",{role:"grid",className:o?"grid list":l?"grid":"grid small","aria-label":by(n,t)},S("tbody",{},...h));f.style.setProperty("--columns",s),f.style.setProperty("--rows",r);let p=[...u.values()].find(m=>Number(m.dataset.point)===t.current)??u.get("0 0");p.tabIndex=0,XP(f,u,e,o);let x=S("div",{className:"upwards"},t.y===null||o?"":xy(i[t.y])),g=S("div",{className:"across"},o?"":xy(i[t.x]));return{element:S("div",{className:r<6?"axes low":"axes"},x,S("div",{},S("div",{className:"scroll"},f),g)),points:d}}function $P(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h,pattern:d}=t.word(o.reasons[s]);n.className=`what ${d}`,n.append(S("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function XP(n,t,e,i){let s=new Map([...t].map(([r,o])=>[o,r.split(" ").map(Number)]));n.addEventListener("click",r=>{let o=r.target.closest("[data-point]");o&&e(Number(o.dataset.point))}),n.addEventListener("keydown",r=>{let o=r.target.closest("[data-point]");if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let[a,l]=s.get(o),[c,u]=gy[r.key]??[0,0],h=i?-u:u,d=Math.max(...[...s.values()].map(([p])=>p)),f={Home:`0 ${l}`,End:`${d} ${l}`}[r.key]??`${a+c} ${l+h}`;if(r.key==="Enter"||r.key===" ")e(Number(o.dataset.point));else{if(!(r.key in gy)&&r.key!=="Home"&&r.key!=="End")return;t.has(f)&&(o.tabIndex=-1,t.get(f).tabIndex=0,t.get(f).focus())}r.preventDefault()})}function qP(n,t,e){let i=lh(n,t),s=[...vy(t,e)].map(([r,o])=>{let a=n.word(r);return S("li",{},Xo(a),`${a.word} (${o})`)});return s.length&&i.push(S("ul",{},...s)),i}function YP({text:n}){let t=(e,i)=>S("li",{},S("span",{className:`line ${e}`,"aria-hidden":"true"}),i);return S("ul",{},t("boundary",`${n}, a straight line in each cell`),t("cell-outline","side of a cell"))}function vy(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function ZP(n,t,e){let i=e.filter(u=>(t.values?.[u]??null)!==null),s=[...vy(t,e)].map(([u,h])=>`${h} ${n.word(u).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`,o=`${n.study.noun}s`;if(!i.length)return`${r} of ${e.length} ${o}: ${s.join(", ")||"none"}.`;let a=s.length?` Other ${o}: ${s.join(", ")}.`:"",[l,c]=[Math.min,Math.max].map(u=>KP(n,t,i,u));return`${r}, known for ${i.length} of ${e.length} ${o}: from ${l} to ${c}.${a}`}function KP(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} ${n.study.noun}s`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function by(n,t){let{factors:e}=n.study,i=t.y===null||t.x===null?e[t.x??t.y].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function xy(n){return n.unit?`${n.name} (${n.unit})`:n.name}function _y(n,t){let e=Math.ceil(n.texts.length/BP);return t%e?"":n.texts[t]}var Sy=2,JP=20;function Ay(n){let t=document.getElementById("live")?.textContent??null,e=t&&JSON.parse(t),i=S("div",{className:"answer"}),s=S("p",{className:"outcome",role:"status"}),r=S("div"),o=S("div"),a=null,l=!1,c=0,u=Promise.resolve(),h=0;function d(_,b){if(h+=1,c=_,!e)return[];if(!xu())return b?[]:[S("p",{className:"note"},`It cannot be simulated here either: ${e.refused}.`)];if(a)x(_);else if(!l){let v=S("button",{type:"button",className:"try"},b?"Try it and refine here":"Simulate it here"),E=S("p",{className:"note"});v.addEventListener("click",()=>f(v,E)),o.replaceChildren(S("div",{className:"offer"},v,E))}return[o]}async function f(_,b){l=_.disabled=!0,b.textContent="Starting the simulator …";try{a=await Oo(Jn(e.bench.clips[0]),e.bench,t,Io),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),x(c)}catch(v){b.textContent=`It cannot be simulated here: ${v.message}.`}}async function p(_,b){if(await u.catch(()=>null),b!==h)return null;u=a.engine.ask({act:"answer",values:_,search:e.search});let{answer:v}=await u;return b===h?v:null}async function x(_){let b=++h,v=S("button",{type:"button"},"Refine here");v.addEventListener("click",()=>m(_)),r.replaceChildren(),i.replaceChildren(s,...Ey(n,e).length?[v]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(e.points[_]);let E=await p(e.points[_],b);E&&(s.textContent=`${Oe(n.pointText(_))}: ${wy(e,E)}.`,g(_))}function g(_){a.sliders.set(e.points[_]),a.engine.send({act:"restart",through:!1})}async function m(_){let b=++h,v=QP(n,e,_),E=new Map,A=S("p",{className:"note",role:"status"}),y=v[1].values.map(D=>v[0].values.map(k=>jP(v,k,D))).reverse(),M=y.map((D,k)=>S("tr",{},S("th",{scope:"row"},My(v[1],v[1].values.length-1-k)),...D.map(({cell:N})=>N))),I=S("tr",{className:"feet"},S("td"),...v[0].values.map((D,k)=>S("th",{scope:"col"},My(v[0],k)))),L=S("table",{className:"grid"},S("caption",{},e2(v,n.study.sampled)),S("tbody",{},...M,I));r.replaceChildren(S("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},L),A);let C=y.flat();for(let[D,{cell:k,values:N,where:B}]of C.entries()){A.textContent=`${D} of ${C.length} points simulated`;let W=await p({...e.points[_],...N},b);if(!W)return;let{sign:H,pattern:st}=n.study.words.find(({word:Y})=>Y===W.word)??n.study.other;k.className=`what ${st}`,k.replaceChildren(S("span",{},H)),k.title=`${B}: ${wy(e,W)}`,k.setAttribute("aria-label",k.title),E.set(W.word,H)}A.textContent=[...E].map(([D,k])=>`${k} ${D}`).join(" · "),g(_)}return{offer:d,get panel(){return a}}}function jP(n,t,e){let i={[n[0].key]:t};n[1].key&&(i[n[1].key]=e);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${be(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:S("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function Ey(n,t){let e=i=>t.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&e(i))}function QP(n,t,e){let i=Ey(n,t),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=t.knobs.find(g=>g.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:t2(t.points.map(g=>g[l]),e)};let h=n.placesOf(e),d=g=>t.points[n.pointAt(h.map((m,_)=>_===a?g:m))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],x=[];for(let g=f;g<p;g++)for(let m=0;m<Sy;m++)x.push(d(g)+m/Sy*(d(g+1)-d(g)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[...x,d(p)]}};return[o(r),o(s)]}function t2(n,t){let[e,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[t]+r*(i-e)/JP);return[...new Set(s.map(r=>Math.min(i,Math.max(e,r))))].sort((r,o)=>r-o)}var My=({key:n,factor:t,unit:e,values:i},s)=>n?`${be(t*i[s])} ${e}`:"";function e2([n,t],e){return`${t.key?`${Oe(n.name)} across, ${t.name} upwards`:Oe(n.name)}, ${e?"around it":"at half the steps"}`}function wy(n,{status:t,least:e}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>e[r]!==null&&e[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${be(l*e[o])} ${c}`});return[t,...s].join("; ")}function ph(n){let t=S("h2"),e=S("p",{className:"outcome",role:"status"}),i=S("table",{className:"numbers"}),s=S("section",{className:"facts",id:"point"},t,e,S("div",{className:"table"},i)),r=S("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=S("div"),a=S("div",{className:"more"}),l=S("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=S("section",{className:"run below","aria-label":"plots and numbers of the run that is open"}),u=Ay(n),h={facts:s,element:l,below:c,point:null,playing:null,answers:u,open:p,show:m},d=null,f=ir();function p(b,{play:v=!1,transition:E=null}={}){h.point=b;let A=n.runsOf(b);t.textContent=Oe(`${n.study.noun} ${b+1}`),e.textContent=`${Oe(n.pointText(b))}: ${n.study.statuses[b]}.`,i.replaceChildren(S("caption",{},n.study.numbers??"Values in the table"),S("tbody",{},...o2(n,b))),r.replaceChildren(...A.length>1?A.map(x):A.map(I=>S("b",{},Oe(I.title))));let y=E===null?null:A.find(I=>I.transition===E),M=v?A.find(I=>I.failed):null;A.length?m(y??M??A[0],{play:v}):(g(),o.replaceChildren(S("p",{className:"note"},a2(n,b))),c.replaceChildren()),a.replaceChildren(...n.study.built[b]?u.offer(b,A.length>0):[])}function x(b){let v=S("button",{type:"button"},b.title);return v.dataset.part=b.part,v.addEventListener("click",()=>m(b,{play:!0})),v}function g(){h.playing?.dispose(),h.playing=null}function m(b,{play:v=!1}={}){g();for(let C of r.querySelectorAll("button"))C.setAttribute("aria-pressed",String(C.dataset.part===b.part));let E=d&&d!==b?d:null,A=E?[E,b]:[b],y={player:S("div"),plots:S("div"),readouts:A.map(()=>S("div"))},[M,I]=[l2,c2].map(C=>A.map((D,k)=>C(D,Ty(A,n)[k]))),L=b.advice?[S("p",{className:"note"},b.advice)]:[];o.replaceChildren(S("p",{},b.text),_(b),...L,y.player),c.replaceChildren(y.plots,...y.readouts,...M,...I),f.scale=n.largestSpan/b.play.clips[0].span_m,h.playing={run:b,beside:E,...n2(y,b,E,n,f)},Do(c),v&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&h.playing.clock.play()}function _(b){let E=S("button",{type:"button",className:"pin"},d?`unpin ${n.study.noun} ${d.point+1}`:"pin to compare with another");return E.addEventListener("click",()=>{d=d?null:b,m(b),o.querySelector(".pin").focus()}),E}return h}function n2(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map((f,p)=>s2(f,Ty(r,i)[p],i)),a=r.map((f,p)=>({...Jn(f.play.clips[0]),...e?{name:o[p]}:{}})),l=Ui(a,e?[r2(a)]:t.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=e?`${Oe(a[0].name)} and ${a[1].name}, side by side with a common clock.`:t.play.text,h=or(n.player,a,l,{...t.play,energy:c,text:u},s);e&&dp(h.stage.cells,a,l,c);let d=ur(n.plots,e?i2(r,a):t.play.plots,a,l);n.plots.classList.toggle("paired",e!==null);for(let[f,p]of a.entries())ar(n.readouts[f],p,l,c,f,e!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function i2(n,t){let e=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:t[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(e.flat().map(s=>s.title))].flatMap(s=>e.flat().filter(r=>r.title===s))}function Ty(n,{study:t}){if(n.length===1)return[""];let e=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${t.noun} ${i.point+1}${e?`, ${i.title}`:""}`)}function s2(n,t,e){let{factors:i}=e.study,s=e.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${t}: ${s.join(", ")}`}function r2(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function o2(n,t){return n.numbers.map(e=>S("tr",{},S("th",{scope:"row"},e.title),S("td",{},n.valueText(e,t))))}function a2(n,t){return n.study.built[t]?`${n.study.unkept??"This run was not kept, so it cannot be played here."} ${n.study.keeps}`:n.study.unbuilt}function l2(n,t){let e=S("div");return e.innerHTML=n.numbers,S("details",{},S("summary",{},`States of ${t||"this run"}`),e)}function c2(n,t){let e=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return S("details",{},S("summary",{},t?`Commands for ${t}`:"Commands"),S("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),S("pre",{},S("code",{},e.join(`
`))))}function mh(n,t,e,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=S("p",{className:"note",role:"status"}),a=u2(t,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(t.study.verdicts[d])||!t.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${t.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=S("button",{type:"button","aria-label":`open ${t.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=t.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");d2(s,r,h2(t));let c=S("div",{className:"choices"},a.element,...e?[p2(e,t.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function u2(n,t){let e=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=S("input",{type:"checkbox",checked:!0});return a.addEventListener("change",t),e.set(o,a),[S("label",{},a,Xo(r),`${r.word} (${r.count})`)]});return{element:S("fieldset",{className:"filter"},S("legend",{},`Show ${n.study.noun}s that`),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function h2(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[e,...i,t.statuses,...s]}function d2(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=S("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,u)=>u).sort((c,u)=>f2(e[s][c],e[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function f2(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function p2(n,t){let e=S("button",{type:"button",className:"button"},`Download ${t}`);return e.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));S("a",{href:i,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),e}function Cy(n){let t=ch(n.study,n.runs),e=ph(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),yp(e)},s=yy(t,(a,l)=>i(a,l.transition)),r=n.runs.length?[[s.element,e.facts],[e.element]]:[[s.element],[e.facts,e.element]];document.getElementById("explorer").replaceChildren(S("div",{className:"explorer"},...r.map(a=>S("div",{},...a)),e.below)),mh(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=m2(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function m2(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function yp({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function Ry(n){let{views:t}=n,e=ry(n.study,n.runs),i=ph(e),s=[],r=(g,m)=>{i.open(g,{play:m});for(let _ of s)_.show?.(g)},o=g=>{r(g,!0),yp(i)},a=ny(e,t.lines,t,o),l=e.columns.filter(g=>g.aim).length===2,c=my(e,{...t,joined:l},o),u=t.pairs?.length?ly(e,t,h):null;s.push(a,c);function h(g,m){c.over(g,m),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=S("div",{className:"explorer"},...d.map(g=>S("div",{},...g)),i.below),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...t.order.map(g=>p[g]));let x=mh(document.getElementById("points"),e,n.csv,o);return e.whenAsked(x),n.study.points&&r(g2(e,n),!1),{model:e,panel:i,lines:a,plane:c,open:o}}function g2(n,{runs:t,views:e,study:i}){let{best:s}=e,r=t.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function Py(n){let t=new Blob([qe(n,Uint8Array)]).stream(),e=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(e,r,c);if(s==="f8")return new Float64Array(e,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(e,r,c),h=x2(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function x2(n,t,e){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<e;o++){s[0]=0;for(let a=0;a<t;a++)s[0]+=n[o*t+a],r[a*e+o]=s[0]}return r}var _2="M7 4.5v15l12-7.5z",y2="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",hr=180/Math.PI,gh=1,Iy=10,Ly=720;function Oy(n,t,e,i){let[s,r]=[n.lowest,n.highest].map(p=>p*hr),o=M2(n),a=S2(n,s,r,o),l=S("button",{type:"button",className:"play"}),c=S("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=S("p",{className:"time"}),h=p=>{t.pause(),t.seek(i(Math.min(r,Math.max(s,p))/hr))},d=()=>t.playing?t.pause():t.play(),f=a.map(({angle:p,name:x})=>{let g=S("button",{type:"button"},S("b",{},Ny(p)),` ${x}`);return g.addEventListener("click",()=>h(p)),g});return c.addEventListener("input",()=>h(Number(c.value))),b2(c,()=>e(t.time)*hr,h,d),l.addEventListener("click",d),t.onChange(()=>{let p=e(t.time)*hr;c.value=p,u.textContent=`${Ny(p,1)}${Dy(n,p)}`,c.setAttribute("aria-valuetext",`${On(p,1)} degrees${Dy(n,p)}`);for(let[g,m]of a.entries())f[g].setAttribute("aria-pressed",String(Math.abs(m.angle-p)<.005));let x=t.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==x&&l.replaceChildren(ml(t.playing?y2:_2)),l.setAttribute("aria-label",x)}),S("div",{className:"transport"},S("div",{className:"line"},l,v2(c,s,r,o,a)),S("div",{className:"choices"},u,S("div",{className:"states"},...f)))}function v2(n,t,e,i,s){let r=S("div",{className:"bands","aria-hidden":"true"}),o=S("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(e-t)}%`;for(let[l,c]of i){let u=S("span",{className:"band"});Object.assign(u.style,{left:a(l-t),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=S("span",{className:c?"tick stop":"tick"});u.style.left=a(l-t),o.append(u)}return S("div",{className:"track"},r,n,o)}function b2(n,t,e,i){let s={ArrowLeft:-gh,ArrowDown:-gh,ArrowRight:gh,ArrowUp:gh},r={PageDown:-Iy,PageUp:Iy,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)e(Math.round(t()+s[o.key]));else if(o.key in r)e(t()+r[o.key]);else return;o.preventDefault()}})}var Ny=(n,t=null)=>`${t===null?On(n,Number.isInteger(Number(n.toFixed(3)))?0:1):On(n,t)}°`;function S2(n,t,e,i){if(n.folds){let a=[{angle:t,name:"flat",stop:!0},{angle:e,name:"folded",stop:!0}];return e>t?a:a.slice(0,1)}let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*hr).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...t<0&&e>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:e>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-t)<1e-6||Math.abs(a-e)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function M2(n){let t=a=>Uy(n,a).every(({longer:l})=>l<0),[e,i]=[n.lowest*hr,n.highest*hr],s=(a,l)=>{let c=t(a);for(let u=0;u<40;u++){let h=(a+l)/2;t(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=t(e)?null:e;for(let a=1;a<=Ly;a++){let[l,c]=[a-1,a].map(u=>e+(i-e)*u/Ly);t(l)!==t(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function Uy(n,t){let e=n.turn(n.anglesTogether(t/hr));return n.straps.flatMap(i=>n.strapStretches(i,e).map(s=>({longer:s,rest:i.rest})))}function Dy(n,t){let e=Uy(n,t);if(!e.length)return"";let i=e.filter(({longer:a})=>a<0).length,s=Math.max(...e.map(({longer:a})=>a));if(i===e.length)return`, straps slack by ${On(-1e3*s,1)} mm or more`;let r=Math.max(...e.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${On(1e3*s,1)} mm (${On(100*r,1)} %)`;return i?`, ${i} of ${e.length} straps slack, others ${o}`:`, straps ${o}`}function ky(n){let t=S("input",{type:"range",min:0,max:100,step:1,value:0});return t.dataset.keys="own",t.addEventListener("input",()=>n(Number(t.value)/100)),t.setAttribute("aria-valuetext","together"),t.addEventListener("input",()=>{t.setAttribute("aria-valuetext",t.value==="0"?"together":`${t.value} % apart`)}),S("label",{className:"slide"},"take apart ",t)}function Fy(n,t,e){let i=n.map((s,r)=>{let o=S("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>e(r,o.checked));let a=S("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,S("label",{},o,a,`${s.name}${t[r]>1?`, ${t[r]}`:""}`)});return S("fieldset",{className:"kinds"},S("legend",{},"show"),...i)}function vp(n,t,e){let i=S("select",{},...t.map((s,r)=>S("option",{value:String(r)},s)));return i.addEventListener("change",()=>e(Number(i.value))),S("label",{},`${n} `,i)}var xh=28,By=24;function zy(n,t){return n.ends.map(e=>{let[i,s]=e.map((r,o)=>new V(...r).applyMatrix4(Yo(t,n.bodies[o])));return i.distanceTo(s)-n.rest})}var w2=new ae,Yo=(n,t)=>t<0?w2:n[t];function bp(n,t,e,i,s){let r=new V(...n.axis).transformDirection(Yo(t,n.bodies[0])),o=new V(...n.up).transformDirection(Yo(t,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,b)=>new V(..._).applyMatrix4(Yo(t,n.bodies[b])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new V().crossVectors(r,o),f=new V().crossVectors(r,d).multiplyScalar(e),x=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,g=A2(s,x>1e-9?h/x:1);return{points:g.map(([_,b],v)=>l[0].clone().addScaledVector(d,_*x).addScaledVector(f,b*x).addScaledVector(r,u*v/(g.length-1))),wide:r,ends:l}})}function A2({values:n,shape:t},e){let[i,s]=t,r=Math.sqrt(Math.max(0,1-e))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?e/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function Vy(n,t,e){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of t){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});Hy(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new V(...n.across[c]).transformDirection(Yo(e,n.bodies[c]));T2(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function Sp(n,t,e){let i=n.places.map(x=>new V(...x).add(e)),[s,r,o,a]=i,l=Yo(t,n.body),[c,u]=[o,a].map(x=>x.clone().sub(e).applyMatrix4(l).add(e)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let x=0;x<=By;x++)p.push(E2(r,h,c,d,f,x/By));return[...p,u]}function E2(n,t,e,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(e,a*a*(1+2*o)).addScaledVector(t,s*o*o*a).addScaledVector(i,-s*a*a*o)}function Gy(n,t){let e={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new V(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new V().crossVectors(l,s);return Array.from({length:xh},(u,h)=>{let d=2*Math.PI*h/xh;return o.clone().addScaledVector(s,Math.cos(d)*t/2).addScaledVector(c,Math.sin(d)*t/2)})});return Hy(e,r,[]),e}function Hy({triangles:n,edges:t},e,i){let s=e[0].length;for(let r=1;r<e.length;r++){let[o,a]=[e[r-1],e[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&t.push(o[l],a[l])}}for(let r of[e[0],e.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function T2({triangles:n,edges:t},e,i,s,r,o){let a=new V(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new V().crossVectors(i,a),c=(u,h,d)=>e.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<xh;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/xh),f=(p,x,g,m)=>n.push(p,x,g,p,g,m);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),t.push(c(h,r,p),c(d,r,p))}}function Wy(n,t){let e=t.map(({origin:a,axis:l})=>[new V(...a),new V(...l)]),i=n.map((a,l)=>t.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new ae),r=new ae,o=new V;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=e[d];r.makeRotationAxis(p,l[d]-t[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var C2=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e]))),R2=new ae;function $y(n,t){let e=n.parts.map(x=>({...x,...x.mesh?P2(x.mesh,t):{}})),i={values:t(n.bows),shape:n.bows.shape},s=Wy(n.bodies,n.turns),r=Math.min(...n.joints.map(x=>x.lower)),o=Math.max(...n.joints.map(x=>x.upper)),a=new Float64Array(n.turns.length),l=n.fold&&t(n.fold);function c(x){if(l)return u(x);for(let[g,m]of n.turns.entries())a[g]=m.built;for(let g of n.joints)a[g.turn]=Math.min(g.upper,Math.max(g.lower,x));return a}function u(x){let[g,m]=n.fold.shape,_=o>0?x/o*(g-1):0,b=Math.min(Math.floor(_),Math.max(g-2,0)),v=Math.min(b+1,g-1);for(let E=0;E<m;E++){let A=l[b*m+E];a[E]=A+(_-b)*(l[v*m+E]-A)}return a}let h=(x,g)=>new V(...x.apart).multiplyScalar(g);function d(x,g,m,_=new ae){let b=h(x,m);return _.copy(x.body===null||x.body<0?R2:g[x.body]).multiply(new ae().makeTranslation(b.x,b.y,b.z))}function f(x,g,{apart:m,side:_}){let b=h(x,m);return x.root?Gy(Sp(x.root,g,b),x.root.diameter):Vy(x.strap,bp(x.strap,g,_,b,i),g)}function p(x,g,{apart:m,side:_}){let b=[];for(let v of x){if(v.outer){let y=d(v,g,m);for(let M of v.outer)b.push(...M.clone().applyMatrix4(y).toArray());continue}let E=h(v,m),A=v.root?[Sp(v.root,g,E)]:bp(v.strap,g,_,E,i).map(y=>y.points);for(let y of A)for(let M=0;M<y.length;M+=4)b.push(...y[M].toArray())}return Float64Array.from(b)}return{parts:e,looks:n.looks,joints:n.joints,folds:!!l,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:c,matrixOf:d,bentMesh:f,outline:p,straps:e.filter(x=>x.strap).map(x=>x.strap),strapStretches:zy}}function P2({points:n,triangles:t,stops:e,edges:i},s){let r=s(n),o=s(t),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:e,edges:s(i),outer:I2(r)}}function I2(n){let t=new Set;for(let[e,i,s]of C2){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=e*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}t.add(r)}return Array.from(t,e=>new V().fromArray(n,e))}function Xy(n,t){let e=t(n.time),i=t(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Pr(e,a),u=Math.min(l+1,e.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:e,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var L2="#14171a",N2=.55,D2=Math.cos(Math.PI/9),O2=.42;function qy(n,t,e,i){let s=n.parts.map(f=>U2(f,n.looks[f.look].colour,i)),r=new Ln;for(let f of s)r.add(f.mesh,f.lines);let o=new Ln,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(e(f));for(let[p,x]of n.parts.entries()){let{mesh:g,lines:m}=s[p],_=!t.hidden.has(x.look);for(let b of[g,m])b.visible=_;_&&(x.places?n.matrixOf(x,a,t.apart,g.matrix):B2(s[p],n.bentMesh(x,a,t)))}}function c(){let f=new $t(me("--accent"));for(let[p,{mesh:x}]of s.entries())for(let g of[x.material].flat())g.emissive.copy(f),g.emissiveIntensity=t.chosen===p?O2:0}function u(f,p){let x=new Mr;x.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:m}of s)m.geometry.boundingSphere===null&&m.geometry.computeBoundingSphere();let[g]=x.intersectObjects(s.map(m=>m.mesh).filter(m=>m.visible),!1);return g?s.findIndex(m=>m.mesh===g.object):null}function h(f){let p=n.parts.findIndex(_=>_.name===f),{mesh:x}=s[p],g=x.geometry.getAttribute("position"),m=new an(g.array.slice(),3);return Array.from(m.applyMatrix4(x.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let x of[f.material,p.material].flat())x.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function U2(n,t,e){let i=(u,h)=>new Ms({color:u,side:zn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?k2(n):new vn,r=n.places?[i(e,!1),i(t,!1)]:i(t,!0),o=new gn(s,r),a=new vn;n.places&&a.setAttribute("position",new an(Yy(n.places,n.edges),3));let l=new Xs({color:L2,transparent:!0,opacity:N2}),c=new br(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function k2({places:n,corners:t,stops:e}){let i=new vn;return i.setAttribute("position",new an(Yy(n,t),3)),i.setAttribute("normal",new an(F2(n,t),3)),i.addGroup(0,3*e,0),i.addGroup(3*e,t.length-3*e,1),i}function Yy(n,t){let e=new Float32Array(3*t.length);for(let[i,s]of t.entries())for(let r=0;r<3;r++)e[3*i+r]=n[3*s+r];return e}function F2(n,t){let e=t.length/3,i=new Float64Array(t.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<e;l++){let[c,u,h]=[0,1,2].map(f=>3*t[3*l+f]),d=(f,p,x)=>n[p+x%3]-n[f+x%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[t[3*l+f]].push(l)}let r=Float64Array.from({length:e},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*t.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<t.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[t[l]])if(d===c||a(c,d)>=D2*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function B2({mesh:n,lines:t},{triangles:e,edges:i}){for(let[s,r]of[[n,e],[t,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new an(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var z2=.25,Zy=60,V2=4;async function Ky(n){let t=await Py(n.arrays),e=$y(n,t),i={apart:0,side:1,hidden:new Set,chosen:null},s=[G2(e,i),...n.motion?[H2(e,i,Xy(n.motion,t))]:[]],r=W2(s),o=document.getElementById("player"),a=X2(o,n,e,i,r),l=j2(e,n,i,a);return a.onPress(l.choose),{model:e,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function G2(n,t){let[e,i]=n.folds?[n.lowest,n.highest]:[n.highest,n.lowest],s=h=>e+h*(i-e),r=h=>(h-e)/(i-e||1),o=Float64Array.from({length:Zy+1},(h,d)=>d/Zy),a=h=>n.anglesTogether(s(h)),l=Jy(n,t,{time:o,anglesAt:a,marks:[],stages:[]}),c=Ui([jy(n,l,a)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);c.setSpeed(z2);let u=Oy(n,c,s,r);return{name:n.folds?"along the fold path":"all joints together",clip:l,clock:c,anglesAt:a,control:u}}function H2(n,t,e){let i=Jy(n,t,e),s=Ui([jy(n,i,e.anglesAt)],e.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:e.anglesAt,control:Ru([i],s)}}function Jy(n,t,{time:e,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!t.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:e,start:e[0],end:e[e.length-1],marks:s,stages:r,readings:[],along:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),t),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function jy(n,t,e){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...t,pointsAt:s=>n.outline(i,n.turn(e(s)),{apart:0,side:1})}}function W2(n){let t=n[0],e={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===t)for(let l of i)l()});let s=()=>t.clock.redraw(),r={get time(){return t.clock.time},get playing(){return t.clock.playing},get span(){return e.of!==t.clock.span&&(e={...t.clock.span,of:t.clock.span}),e},clipTime:(a,l)=>t.clock.clipTime(a,l),timeAt:a=>t.clock.timeAt(a),wayAt:a=>t.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>t.clock.seek(a),seekClip:(a,l)=>t.clock.seekClip(a,l),step:a=>t.clock.step(a),play:()=>t.clock.play(),pause:()=>t.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>t.clip.pointsAt(a)},clock:r,sources:n,get now(){return t},anglesAt:a=>t.anglesAt(a),take(a){t.clock.pause(),t=n[a],e={of:null},s()},changed(){e={of:null},s()}}}var Qy="Press a part, or its name in the table, for details.",$2="parts";function X2(n,t,e,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=Qa([r],o,()=>l=qy(e,i,s.anglesAt,t.stopColour),t.text),h=Iu(u.eye,null);h.prepend(Tu(u,o,()=>({text:"",longest:0}),()=>[]));let d=S("div",{className:"picture"},u.element,...u.note?[u.note]:[],h),f=S("p",{className:"chosen",role:"status"},Qy),p=S("div",{},a[0].control);return n.replaceChildren(d,f,p,q2(e,i,s,p),Y2(e,i,s),Z2(t,e,u),vu([r],$2)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),bu(n,[r],o,u.eye,Ir[0]),{stage:u,shape:l,info:f,repaint:()=>{l.paint(),o.seek(o.time)},onPress:x=>J2(u.canvas,g=>x(l.at(g,u.eye.camera)))}}function q2(n,t,e,i){let s=l=>{Object.assign(t,l),e.changed()},r=e.sources.map(l=>l.name),o=vp("motion",r,l=>{e.take(l),i.replaceChildren(e.now.control)}),a=vp("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return S("div",{className:"choices"},...r.length>1?[o]:[],ky(l=>s({apart:l})),...n.straps.length?[a]:[])}function Y2(n,t,e){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return Fy(n.looks,i,(s,r)=>{r?t.hidden.delete(s):t.hidden.add(s),e.changed()})}function Z2(n,t,e){let i=S("span",{className:"swatch taut","aria-hidden":"true"});return S("ul",{className:"legend"},...t.parts.some(s=>s.stops)?[K2(n.stopColour,"face of a stop")]:[],...t.straps.length?[S("li",{},i,"on the slider: range of taut straps")]:[],S("li",{},`squares of the grid: ${be(1e3*Ka(e.eye.size))} mm`))}function K2(n,t){let e=S("span",{className:"swatch panel","aria-hidden":"true"});return e.style.background=n,S("li",{},e,t)}function J2(n,t){let e=null;n.addEventListener("pointerdown",i=>{e=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(e===null||Math.hypot(i.clientX-e[0],i.clientY-e[1])>V2)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];t(new Yt(2*r-1,1-2*o))})}function j2(n,t,e,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=S("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(e.chosen===c?null:c)),h});function o(l){e.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?Qy:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}var Q2=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],tI=1.35;function Mp(n,t,e=[],i=null){let s=t.map(r=>eI(r,e[0],i));n.replaceChildren(...s.map(r=>r.element)),n.classList.add("plots");for(let r of s)r.start();return s}function eI(n,t,e){let[i,s,r]=[n.lines,n.balls,n.marks].map(y=>y.map(nI)),{element:o,head:a,key:l,place:c}=op(n),u=(s.length?s:[i[0]]).map(y=>S("span",{className:"ball"},s.length&&y.name.length<3?y.name:"")),h=s.map(y=>[y.places[0],y.values[0]]),d=Math.round(tI*rh),f=iI(i),p=f,x=null,g=[];function m(){let y=i.map((I,L)=>S("li",{},mr(Oi(L)),I.name)),M=s.length?`the ${n.along} now`:"moved by the slider";l.replaceChildren(...y,S("li",{},S("span",{className:"ball still"}),M))}function _(){for(let[y,[M,I]]of h.entries()){let[L,C]=[x.valToPos(M,"x"),x.valToPos(I,"y")];u[y].style.transform=`translate(${L.toFixed(2)}px, ${C.toFixed(2)}px)`}}function b(){let y=e.clipTime(0);for(let[M,{places:I,values:L}]of s.entries())h[M]=[I,L].map(C=>nr(t.time,C,y));_()}function v(y){p=y,x.setScale("x",{min:y[0],max:y[1]})}function E(y,M,I){if(p!==f){let{places:D,values:k}=i[0],N=k.filter((H,st)=>D[st]>=p[0]&&D[st]<=p[1]),[B,W]=[Math.min(...N),Math.max(...N)];return[B-.25*(W-B),W+.25*(W-B)]}let L=s.reduce((D,k)=>Math.max(D,k.most),I),C=Math.min(0,M);return[C-.06*(L-C||1),L+.1*(L-C||1)]}function A(){let y=ln.join(i.map(L=>[L.sorted.places,L.sorted.values]));x=new ln(sI({data:n,lines:i,balls:s,marks:r,energyRange:E},c.clientWidth,d),y,c),x.over.append(...u);let M=new ResizeObserver(()=>x.setSize({width:c.clientWidth,height:d}));M.observe(c),x.hooks.setSize=[_],x.hooks.setScale=[_],m();let I=tr(()=>{m(),x.redraw(!1)});a.append(ap(n,()=>x,{under:()=>[],over:()=>[...tv(x,n.along==="run"?s:[]),...ev(x,r)]})),g=[I,()=>M.disconnect(),()=>x.destroy()],n.top&&c.after(rI(f,n.top,v)),s.length?(e.onChange(b),oI(x,s,t,e)):aI(n,i[0],c,(L,C)=>{h[0]=[L,C],_()}),v(f)}return{element:o,start:A,dispose:()=>g.forEach(y=>y()),now:h,get chart(){return x}}}function nI({name:n,places:t,values:e}){let i={name:n,places:qe(t,Float32Array),values:qe(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function iI(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function sI({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=oh(),l=up(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...lp(t)],axes:[{...a,...cp,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:Q2,space:44},l],hooks:{draw:[c=>sh(c,[...tv(c,n.along==="run"?e:[]),...ev(c,i)])]}}}function tv(n,t){let[e,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return t.flatMap(({places:r,values:o})=>Array.from(r,(a,l)=>[n.valToPos(a,"x"),n.valToPos(o[l],"y")])).filter(([r,o])=>r>0&&r<e&&o>0&&o<i).map(([r,o])=>({kind:"rect",x:r-.8,y:o-.8,width:1.6,height:1.6,fill:me("--accent"),opacity:.55}))}function ev(n,t){let[e,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],s=t.flatMap(({name:r,places:o,values:a})=>{let l=Array.from(o,(f,p)=>[n.valToPos(f,"x"),n.valToPos(a[p],"y")]),[c,u]=l[l.length>>1],h=l.length===1?{kind:"circle",x:c,y:u,r:4.5,fill:me("--page"),stroke:me("--ink"),lineWidth:1.4}:{kind:"path",points:l,stroke:me("--line-2"),lineWidth:7,opacity:.35},d=l.length>1?0:c>e/2?-1:1;return[h,{kind:"text",x:c+12*d,y:u-9,text:r,anchor:["end","middle","start"][d+1],fill:me("--ink")}]});return[{kind:"clip",x:-6,y:0,width:e+12,height:i+6,shapes:s}]}function rI(n,t,e){let i=[["whole curve",n],["barrier enlarged",t]].map(([s,r],o)=>{let a=S("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return S("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function oI(n,t,e,i){hp(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of t)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,e.time[c])})}function aI(n,t,e,i){let s=t.places.length-1,r=S("input",{type:"range",min:"0",max:String(s),value:"0"});r.setAttribute("aria-label",`${n.axis} along the curve`);let o=S("output",{"aria-live":"off"}),a=()=>{let l=Number(r.value);i(t.places[l],t.values[l]);let[c,u]=[be(t.places[l]),`${be(t.values[l])} ${n.unit}`];o.textContent=`${c}°, ${u}`,r.setAttribute("aria-valuetext",`${n.axis} ${c} degrees, energy ${u}`)};r.addEventListener("input",a),e.after(S("div",{className:"slide"},r,o)),a()}function _h(n,t,e){let i=t.map(({name:l,title:c})=>{let u=S("button",{type:"button",title:`${l}: ${c}`},l);return u.addEventListener("click",()=>e(l)),u}),s=l=>{for(let c of i)c.setAttribute("aria-pressed",String(c.textContent===l))},r=t.map(({name:l,title:c})=>`${l}: ${c}`).join(" · "),o=`how the ${n} moves`;return{element:S("div",{className:"colours modes",role:"group","aria-label":o},S("span",{},...i),S("small",{},r)),mark:s}}function wp(n){let t=(n.paths??[]).map(c=>({...c,clips:c.clips.map(u=>({...n.clips?.[0],...u}))})),i=[...n.clips?[{...n,name:"motion",title:"in time, as simulated"}]:[],...t].map(lI),s={views:i};if(!i.length)return{...s,curves:Mp(document.getElementById("curves"),n.curves)};let r=document.getElementById("player"),o=null,a;s.choose=c=>{o?.leave(),o=c,a=c.show(a)??a,Object.assign(s,c),l.mark(c.name)};let l=_h(n.whole,i,c=>s.choose(i.find(u=>u.name===c)));if(i.length>1&&r.before(l.element),s.choose(i[0]),n.clips){ah(r,s.clock);let c=i.find(h=>h!==i[0]),u=c&&(()=>{s.choose(c),r.scrollIntoView({block:"start"}),r.querySelector("input[type=range]").focus({preventScroll:!0})});s.trial=Uu(document.getElementById("try"),i[0].clips[0],n,()=>s.clock.pause(),u)}return s}function lI(n){let{name:t,title:e}=n,i=n.clips.map(Jn),s={name:t,title:e,clips:i,clock:null},r=[];return s.show=o=>{let a=u=>document.getElementById(u),l=Ui(i,n.spans);return s.clock&&l.seek(s.clock.time),s.clock=l,s.player=or(a("player"),i,l,n,o,!1),s.curves=n.curves?Mp(a("curves"),n.curves,i,l):[],s.plots=ur(a("plots"),n.plots,i,l),n.notes&&a("player").append(...n.notes.map(u=>S("p",{className:"note"},u))),r=[ar(a("readout"),i[0],l,n.energy),()=>s.player.dispose(),()=>s.plots.dispose(),()=>s.curves.forEach(u=>u.dispose())],s.player.stage?.eye.look},s.leave=()=>r.forEach(o=>o()),s}var iv={"Content-Type":"application/json"},nv=19e6;async function Is(n,t,e){let i=JSON.stringify(t);if(i.length>nv)return{refused:`need files of at most ${nv/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:iv,body:i,signal:e})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:Ap}}}async function yh(n,t,e,i){let s="",r={};try{let a=(await fetch(n,{method:"POST",headers:iv,body:JSON.stringify(t),signal:e})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let u of c)r=JSON.parse(u),i(r)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:Ap}}return r.done||r.refused?r:{refused:Ap}}var Ap="the workbench does not answer; is forficula open still running?";var Ep=`forficula ${location.pathname}`;function rv(n){let t={asked:null,base:null,reply:null,rejected:new Map};t.open=async(r,o)=>{let a=r.files[0]?.name||r.design||"the design",l={...r,settings:o};n.says.wait(`Opening ${a}`);let c=n.picture(l,!0),u=await Is("design",{...r,settings:{}}),h=u.refused??await e(l,u,c);return h?(n.says.refuse(`${a} is not opened: ${h}`),n.resume()):t.rejected.clear(),t.reply&&s(t.reply),h};async function e(r,o,a=null){let l=performance.now(),c=new AbortController,u=()=>{Object.assign(t,{asked:r,base:o}),s(h)};n.says.wait("Building",()=>c.abort());let h=o;try{if(Object.keys(r.settings).length&&(h=await Is("design",r,c.signal)),h.refused)return h.refused;let d=await cI(a??n.picture(r,!1),c.signal);if(d.refused)return d.refused;d.shown&&(u(),n.says.wait("Building"));let f=await Is("model",r,d.shown?void 0:c.signal);if(f.refused&&!d.shown)return f.refused;d.shown||u(),await n.model(f.refused?{live:f,warnings:[]}:f),n.says.done(`Built in ${((performance.now()-l)/1e3).toFixed(1)} s.`)}catch(d){if(d.name!=="AbortError")throw d;return"building was stopped"}return""}t.change=async(r,o)=>{let{asked:a,rejected:l}=t,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),u=i(a.settings,[[r,o]]),h=c.length?[i(a.settings,[...c,[r,o]]),u]:[u],d="";for(let f of h)if(d=sv(f,a.settings)?"":await e({...a,settings:f},t.base),!d){f===h[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`),n.resume()):sv(u,a.settings)&&n.says.done(""),s(t.reply)},t.slide=async r=>{let o=i(t.asked.settings,Object.entries(r)),a=await Is("design",{...t.asked,settings:o});return a.refused?n.says.refuse(a.refused):(t.asked={...t.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===t.base.keys.find(u=>u.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){t.reply=r,uI(t.asked),n.reply(t)}return t}function cI(n,t){let e=new Promise((i,s)=>t.addEventListener("abort",()=>s(t.reason)));return Promise.race([n,e])}var sv=(n,t)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(t).sort());function ov(){return JSON.parse(sessionStorage.getItem(Ep)??"null")}function uI(n){try{sessionStorage.setItem(Ep,JSON.stringify(n))}catch{sessionStorage.removeItem(Ep)}}function av(n){let t=S("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),e=S("button",{type:"button"},"Build this text"),s=S("div",{},S("label",{htmlFor:"file-text"},"The design file"),S("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),t,S("p",{className:"choices"},e));e.addEventListener("click",()=>n(t.value));let r="";return{element:s,show(o){o.text!==r&&(t.value=r=o.text)}}}function vh(n,t){let e="";for(let i of new TextEncoder().encode(n))e+=String.fromCharCode(i);return`data:${t};base64,${btoa(e)}`}var Tp=40,hI=0;function lv(n,t){let e=`key-${++hI}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=dI(n,e),r=S("button",{type:"button",className:"home",hidden:!0},"undo"),o=S("p",{className:"wrong",id:`${e}-wrong`}),a="",l=S("p",{className:"note",id:`${e}-notes`}),c=S("div",{className:"field"},S("label",{htmlFor:e,title:n.key},i),S("span",{className:"entry"},s,...fI(n,e),r),o,l);s.setAttribute("aria-describedby",`${e}-wrong ${e}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),t(a)}),r.addEventListener("click",()=>{t(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function u(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),h("");let x=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",x!==null),r.hidden=x===null;let g=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",_=[d.allowed,x===null?g:`was ${x}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(Oe(d.meaning),S("span",{className:"may"},_))}function h(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:u,reject:h}}function dI({key:n,value:t,words:e,onlyWords:i,default:s},r){if(i){let l=t?[]:[S("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return S("select",{id:r,"data-key":n},...l,...e.map(c=>S("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(t.length>Tp)return S("textarea",{...o,rows:Math.min(6,Math.ceil(t.length/Tp))});let a=S("input",{...o,type:"text"});return e.length&&a.setAttribute("list",`${r}-words`),a}function fI({words:n,onlyWords:t,value:e},i){return t||!n.length||e.length>Tp?[]:[S("datalist",{id:`${i}-words`},...n.map(s=>S("option",{value:s})))]}var pI=["pattern","tendon"];function cv(n){let t=S("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),e=S("p",{className:"note",role:"status"}),i=S("div",{className:"sections"}),s=S("section",{className:"keys-of-design","aria-label":"keys of the design"},S("h2",{},"Keys"),S("label",{className:"find",htmlFor:"find-key"},"Find a key",t),e,i),r=new Map,o=[];t.addEventListener("input",a);function a(){let h=t.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let x=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!h.every(g=>x.includes(g)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:x}of f.parts)p.hidden=x.every(g=>g.element.hidden);h.length&&!f.element.hidden&&(f.element.open=!0)}e.textContent=h.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(h,d,f){let p=new Map(f.keys.map(x=>[x.key,x]));mI(h.keys,r)||c(h);for(let x of h.keys)r.get(x.key).show(x,d[x.key],p.get(x.key));for(let x of o)x.count(d);a()}function c(h){let d=new Set(o.length?o.filter(({element:x})=>x.open).map(({name:x})=>x):pI),f=document.activeElement?.dataset?.key;r=new Map(h.keys.map(x=>[x.key,lv(x,g=>n(x.key,g))])),o=[...new Set(h.keys.map(({key:x})=>x.includes(".")?x.split(".")[0]:""))].sort((x,g)=>(g===""?-1:0)-(x===""?-1:0)).map(x=>gI(x,h,r));for(let x of o)x.element.open=d.has(x.name);i.replaceChildren(...o.map(x=>x.element)),f&&r.get(f)?.input.focus()}function u(h,d,f){let p=r.get(h);if(p){p.reject(f,d);for(let x of o)x.fields.includes(p)&&(x.element.open=!0)}}return{element:s,show:l,reject:u,field:h=>r.get(h)}}function mI(n,t){let e=[...t.keys()],i=(s,r)=>s.key===r&&s.onlyWords===t.get(r).fact.onlyWords;return n.length===e.length&&n.every((s,r)=>i(s,e[r]))}function gI(n,t,e){let i=t.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>e.get(d)),r=S("summary"),o=t.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=t.keys.find(g=>g.key===`${n}.${f}.name`)?.value,x=S("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:x,fields:[]}),l.push(x)}a.at(-1)?.fields.push(e.get(d)),l.push(e.get(d).element)}let c=o?[S("p",{className:"note"},`${Oe(o).replace(/\.$/,"")}.`)]:[],u=S("details",{},r,...c,...l);function h(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?Oe(n):"Name",...f?[S("small",{},` ${f} changed`)]:[])}return{name:n,element:u,fields:s,parts:a.filter(({heading:d})=>d),count:h}}function uv(n,t,e){let i=S("option",{value:""},t),s=n.filter(({name:f})=>f!==t).map(({name:f,shows:p})=>S("option",{value:f,title:p},f)),r=S("select",{id:"which-design"},i,...s),o=S("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf",className:"spoken"}),a=S("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),l="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf) can be dropped anywhere on the page.",c=S("label",{className:"button",htmlFor:"which-files"},"Open files …"),u=S("div",{className:"opening choices"},S("label",{htmlFor:"which-design"},"design ",r),S("span",{className:"choosing"},o,c),S("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",a),S("p",{className:"note"},l));r.addEventListener("change",()=>e({design:r.value,files:[],unit:""})),o.addEventListener("change",async()=>{o.files.length&&await d([...o.files]),o.value=""}),a.addEventListener("change",()=>{h&&e({design:"",files:h,unit:a.value.trim()})});let h=null;async function d(f){let p=await Promise.all(f.map(async x=>({name:x.name,text:await x.text()})));h=xI(p),await e({design:"",files:h,unit:a.value.trim()})}return _I(d),{element:u,show({design:f,files:p}){r.querySelector(".sent")?.remove(),p.length&&r.append(S("option",{value:p[0].name,className:"sent"},p[0].name)),r.value=p.length?p[0].name:f,h=p.length?p:null}}}function xI(n){let t=n.filter(({name:i})=>/\.toml$/i.test(i)),e=t.find(({name:i})=>!t.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[e,...n.filter(i=>i!==e)]}function _I(n){let{body:t}=document,e=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),t.classList.add("dropping"))};t.addEventListener("dragenter",e),t.addEventListener("dragover",e),t.addEventListener("dragleave",i=>{i.relatedTarget||t.classList.remove("dropping")}),t.addEventListener("drop",i=>{t.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function hv(n,{button:t,text:e,title:i},s){let r=S("button",{type:"button",className:"try"},t),o=S("button",{type:"button",hidden:!0},"Stop"),a=S("p",{className:"note",role:"status"},e),l=S("div"),c=S("div",{className:"results"},S("div",{className:"offer"},r,o,a),l),u=null,h=null;async function d(){if(h)return;let x=s(),g=performance.now();h=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let m=!1;try{let _=await yh(n,x,h.signal,b=>{b.doing&&(a.textContent=`${b.doing} …`)});_.refused?a.textContent=`No result: ${_.refused}.`:f(_.done,x,(performance.now()-g)/1e3),m=!_.refused}catch{a.textContent="Stopped."}h=null,r.disabled=!1,o.hidden=!0,m&&p()}function f(x,g,m){u=JSON.stringify(g),a.textContent=`Done in ${m.toFixed(m<10?1:0)} s.`;let _=S("a",{href:x,target:"_blank",rel:"noopener"},"Open in a new window"),b=S("iframe",{src:x,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(S("p",{},_),b)}function p(){u!==null&&!h&&u!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>h?.abort()),{element:c,find:d,seen:p}}var yI=1500;function dv(){let n=S("p",{role:"status"}),t=S("p",{className:"wrong",role:"alert"}),e=S("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;e.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),e.hidden=!0,n.textContent=o,t.textContent=a}return{element:S("div",{className:"says"},n,e,t),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>e.hidden=!1,yI))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function fv(){let n=S("a",{className:"button"},"Download the design"),t=S("code"),e=S("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},t);return{element:S("div",{className:"taking"},n,e),show(i){n.href=vh(i.text,"application/toml"),n.download=`${i.name}.toml`,t.textContent=i.command}}}function pv(n){let t=S("div"),e=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===e)return;e=r,t.querySelector("img")||t.replaceChildren(S("p",{className:"note",role:"status"},"Drawing …"));let o=await Is("pattern",s);if(e!==r)return;if(o.refused){t.replaceChildren(S("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=S("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(u,h,d)=>S("a",{className:"button",download:h,href:d},u),c=vh(o.fold,"application/json");t.replaceChildren(S("figure",{className:"drawn"},a),S("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:t,seen:i}}function mv(n){let t={},e=0;function i(){if(clearTimeout(e),!Object.keys(t).length)return;let s=t;return t={},n(s)}return{put(s,r){t[s]=r,clearTimeout(e),e=setTimeout(i,250)},hand:i}}function gv(n,t){let e=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let u=S("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return u.addEventListener("click",()=>r(c)),u}),i=S("div",{className:"tabs",role:"tablist","aria-label":t},...e),s=0;function r(o){s=o;for(let[a,l]of e.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:e.length-1};o in a&&(r((a[o]+e.length)%e.length),e[s].focus())}),{element:S("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>e[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}var xv=.02;function _v(n,{moving:t,shape:e,names:i,asked:s,held:r}){let o=S("p",{className:"note",role:"status"}),a=S("button",{type:"button","aria-pressed":"false",title:"drag panels as well; otherwise dragging a panel turns the picture"},"drag panels");a.addEventListener("click",()=>a.setAttribute("aria-pressed",String(a.getAttribute("aria-pressed")!=="true")));let l=null,c=!1,u=!0,h=!0;async function d(){if(c||!l)return;let{place:A,target:y}=l,M={...s(),weights:Object.fromEntries(A),target:y,begins:u};l=null,u=!1,c=!0;let I=await Is("drag",M);c=!1,h||f(I),d()}function f(A){let y=A.refused?`Not dragged: ${A.refused}.`:A.text;A.points&&(t.hold(qe(A.points,Float32Array)),r(!0)),m.say(y),o.textContent=y}function p(A,y){h&&(u=!0),h=!1,l={place:A,target:y.toArray()},d()}function x(){h=!0,l=null,t.hold(null),r(!1)}function g(A,y){if(a.getAttribute("aria-pressed")!=="true")return null;let M=new Mr;M.setFromCamera(new Yt(A,y),n.eye.camera);let{mesh:I}=t,L=null,C=[new V,new V,new V],D=new V,{vertices:k}=n.views[0].shape;for(let B=0;B<I.triangles.length;B+=3){let W=I.triangles.slice(B,B+3);for(let[st,Y]of W.entries())C[st].fromArray(k,3*Y);if(!M.ray.intersectTriangle(...C,!1,D))continue;let H=D.distanceTo(M.ray.origin);(!L||H<L.away)&&(L={away:H,numbers:W,shares:Ki.getBarycoord(D,...C,new V).toArray()})}if(!L)return null;let N=new Map;for(let[B,W]of L.numbers.entries())for(let[H,st]of[[I.between[2*W],1-I.share[W]],[I.between[2*W+1],I.share[W]]])st&&N.set(H,(N.get(H)??0)+st*L.shares[B]);return[...N]}let m=Du(n,{points:e,movable:i.map(A=>A!==null),between:g,moved:(A,y,M)=>p(A,M),left:x}),_=vI(n,e,i,p,x),b=S("p",{className:"note"},"Drag a vertex: the package computes the equilibrium with the springs of the creases, and the force that holds it."),v=S("div",{className:"drag"},b,o,_.element);return n.element.parentElement.querySelector(".views").prepend(S("span",{className:"panels"},a)),{element:v,end:_.end}}function vI(n,t,e,i,s){let r=Lu(e.map((f,p)=>[f,p]).filter(([f])=>f!==null)),o=Nu("drag",{clicked:u,pressed:u}),a=S("button",{type:"button"},"Release"),l=S("p",{className:"note"},"On these buttons, every arrow key drags the vertex by 2 % of the structure's size. It stays there until it is released."),c=null;function u(f){let[p,x]=el[f],g=Number(r.value);c??=new V().fromArray(t(),3*g);let{camera:m,size:_}=n.eye;c.addScaledVector(new V().setFromMatrixColumn(m.matrixWorld,0),xv*_*p),c.addScaledVector(new V().setFromMatrixColumn(m.matrixWorld,1),xv*_*x),i([[g,1]],c)}function h(){c=null,s()}return r.addEventListener("change",h),a.addEventListener("click",h),{element:S("details",{className:"push-keys"},S("summary",{},"Drag without a pointer"),S("div",{className:"choices"},S("label",{},"point ",r),o,a),l),end:h}}function yv(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}var Cp=100;function vv(){let n=S("p",{className:"note",role:"status"}),[t,e,i,s]=["","notes","",""].map(p=>S("div",{className:p})),r=S("div",{className:"folding"},n,t,e,i,s),o={element:r,whole:"structure",share:0,complete:!1,clock:null,path:null},a=null,l=null,c=null;Object.defineProperty(o,"look",{get:()=>c?.look}),o.show=(p,{fresh:x=!1,look:g}={})=>{o.leave(),x&&(o.share=0);let m=l=Object.assign(new AbortController,{wanted:p}),_=performance.now(),b=null;return new Promise(v=>{let E=A=>{A.picture&&(b=A.picture,o.whole=b.whole,(x||!c?.grow)&&h(b,g),a=p,o.complete=!1,n.textContent="Computing the fold path …",v({shown:!0})),A.path&&d(b,A.path,m),A.done&&(n.textContent=SI(o.path,(performance.now()-_)/1e3))};yh("fold",{...p,share:x?null:o.share},m.signal,E).then(({refused:A})=>{v({refused:A}),!(!A||l!==m)&&(b&&c?.grow&&h(b,g),b&&(n.textContent=`No fold path is shown: ${A}.`))},()=>v({refused:"building was stopped"}))})},o.shows=p=>c!==null&&JSON.stringify(a)===JSON.stringify(p),o.leave=()=>{l?.abort(),l=null},o.resume=()=>{!l||l.wanted===a||(o.leave(),a&&!o.complete&&o.show(a))},o.clear=()=>{o.leave(),u(),a=null};function u(){if(!c)return;let{look:p}=c;c.dispose(),c=null,o.clock=o.path=null;for(let x of[t,e,i,s])x.replaceChildren();return p}function h(p,x){let g=u()??x??ir(),m=Jn(p.clips[0]),{stage:_}=Pu(t,[m],yv(m),{...p,text:`${p.shape}, as built.`},{...g,following:!1});t.setAttribute("aria-label",`the ${p.whole} as built`),c={clip:()=>m,look:_?.eye.look??g,dispose:()=>_?.dispose()}}function d(p,x,g){let m=Jn({...p.clips[0],...x.clips[0]});o.path=x,c?.mine===g&&c.largest===x.energy.largest_J?c.grow(m,x):f(m,x,g,p.points),x.complete&&c.complete(x),o.complete=x.complete}function f(p,x,g,m){let _=t.contains(document.activeElement),b=c?.clip(),v=u()??ir(),E=bI(p);b?.mesh.pointCount===p.mesh.pointCount&&E.lend(b);let A=Ui([E],x.spans);A.seek(Cp*o.share);let y=or(t,[E],A,x,v,!1);y.stage?.eye.aim(),E.lend(null);let M=null,I=()=>{o.share!==A.time/Cp&&M?.end(),o.share=A.time/Cp},L=[()=>y.dispose(),A.onChange(I)];c={mine:g,clip:E.now,look:y.stage?.eye.look??v,largest:x.energy.largest_J,dispose:()=>L.forEach(C=>C()),grow(C){E.replace(C),A.redraw()},complete({plots:C,notes:D,energy:k,spans:N}){A.setSpan({...N[0]}),e.replaceChildren(...D.map(H=>S("p",{className:"note"},H)));let B=H=>{r.classList.toggle("pulled",H),A.redraw()};if(y.stage){let H=()=>E.pointsAt(A.clipTime(0));M=_v(y.stage,{moving:E,shape:H,names:m,asked:()=>({...a,share:o.share}),held:B}),(t.querySelector(".crease-choice")??t.querySelector(".transport")).after(M.element)}let W=ur(i,C,[E],A);L.push(()=>W.dispose(),ar(s,E,A,k))}},Object.assign(o,{clock:A,stage:y.stage,moving:E,path:x}),_&&t.querySelector("input[type=range]").focus({preventScroll:!0})}return o}function bI(n){let t=n,e=null,i=null,s={now:()=>t,replace:r=>t=r,lend:r=>e=r,hold:r=>i=r,pointsAt(r,o){return i?o?(o.set(i),o):i:(e??t).pointsAt(r,o)},verticesAt:(r,o)=>i?t.verticesOf(i,o):t.verticesAt(r,o)};return new Proxy(s,{get:(r,o)=>s[o]??t[o]})}function SI(n,t){let e=`${t.toFixed(t<10?1:0)} s`;return n.reached?`The fold path was computed in ${e}.`:`The fold path was computed in ${e}; it does not reach its goal.`}var MI=[{name:"live",title:"simulated in time"},{name:"fold",title:"slowly along its path"}];function Sv(n,t,e){let i=S("div"),s=vv(),r={element:i,fold:s,panel:null,whole:"structure",refused:"",engine:null},o="live",a=null,l,c;function u(){let m=r.panel?.stage?.eye.look;l=m?{...m,closer:m.closer/Ou}:s.look??l,c=r.panel?.pace??c}function h(){u(),r.panel?.leave(),r.panel=null}r.begin=async(m,_)=>{if(!_&&r.panel)return{};let b=await s.show(m,{fresh:_,look:l});return b.shown&&(h(),r.whole=s.whole,i.contains(s.element)||i.replaceChildren(s.element)),b},r.resume=()=>s.resume(),r.show=async m=>{a=m,r.whole=a.bench?.whole??s.whole,r.refused=a.live.refused??"",!r.refused&&o==="live"?await d():await f()};async function d(){let{bench:m,live:_,warnings:b}=a;u();try{let v=await Oo(Jn(m.clips[0]),m,JSON.stringify(_),x,{look:wI(l),pace:c,set:t});h(),s.clear(),i.replaceChildren(p(),v.element,...bv(b)),v.begin(),r.panel=v}catch(v){r.engine?.end(),r.engine=null,r.refused=v.message,await f()}}async function f(){h(),i.replaceChildren(...r.refused?[]:[p()],s.element,...r.refused?[g()]:[],...bv(a.warnings)),s.shows(n())||await s.show(n(),{look:l})}function p(){let m=_h(r.whole,MI,async _=>{_!==o&&(o=_,await(_==="live"?d():f()),[...i.querySelectorAll(".modes button")].find(b=>b.textContent===o)?.focus())});return m.mark(o),m.element}async function x(m,_){return r.engine?r.engine.take(m,_):(r.engine=await Io(m,_),r.engine)}function g(){let m=S("p",{className:"note"},`The motion in time is not simulated in this page: ${r.refused}. The package simulates it.`),_=S("button",{type:"button"},"Run it");return _.addEventListener("click",e),S("div",{className:"offer"},_,m)}return r}var wI=n=>n&&{...n,following:!1,closer:Ou*n.closer};function bv(n){if(!n.length)return[];let t=e=>`${e.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[S("h2",{},"What to know"),S("ul",{className:"warnings"},...n.map(e=>S("li",{},t(e))))]}var AI={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function Mv(n){let t=dv(),e=Promise.resolve(),i=x=>e=e.then(x).catch(g=>t.refuse(g.message)),s=rv({says:t,reply:d,picture:(x,g)=>u.wing.begin(x,g),model:f,resume:()=>u.wing.resume()}),r=mv(x=>i(()=>s.slide(x))),o=null,a=x=>(o=x,i(()=>o===x&&s.open(x,{}))),l=uv(n.designs,n.opened,a),c=cv((x,g)=>{r.hand(),i(()=>s.change(x,g))}),u=TI(s,r,a),h=fv();function d({asked:x,base:g,reply:m,rejected:_}){document.title=`${m.title}: workbench`,document.querySelector("h1").textContent=m.title,l.show(x),c.show(m,x.settings,g);for(let[b,{text:v,why:E}]of _)c.reject(b,v,E);u.file.show(m),h.show(m),u.tabs.seen()}async function f(x){await u.wing.show(x),u.tabs.name("wing",Oe(u.wing.whole))}let p=S("div",{className:"masthead"},l.element,h.element,t.element);return document.getElementById("workbench").append(p,c.element,u.tabs.element),u.tabs.choose("wing"),await i(()=>EI(s,n)),Object.assign(s,{wing:u.wing,idle:()=>e})}async function EI(n,t){let e=ov();e&&!await n.open({design:e.design,files:e.files,unit:e.unit},e.settings)||await n.open({design:"",files:[],unit:""},t.settings)}function TI(n,t,e){let i=()=>n.asked,s=Object.fromEntries(Object.entries(AI).map(([c,u])=>[c,hv(c,u,i)])),r=Sv(i,t.put,()=>{l.choose("run"),s.run.find()}),o=pv(i),a=av(c=>e({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:c}],unit:""})),l=gv([{name:"wing",title:"Structure",element:r.element},{name:"sheet",title:"Pattern",...o},{name:"landscape",title:"Landscape",...s.landscape},{name:"run",title:"Run",...s.run},{name:"file",title:"File",element:a.element}],"views of the design");return{tabs:l,wing:r,file:a}}var CI={run:wp,compare:Y_,curves:wp,study:Cy,goals:Ry,parts:Ky,bench:fx,workbench:Mv},Rp=JSON.parse(document.getElementById("data").textContent);Jp(Rp.reading_units);function wv(n){let t=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(S("p",{className:"note",role:"alert"},t)),n}function Av(n){window.forficula=n}try{let n=CI[Rp.kind](Rp);n instanceof Promise?n.then(Av,wv):Av(n)}catch(n){wv(n)}Kp();Do();})();
